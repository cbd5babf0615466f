// What a page has made: clips, pictures and busts, by this program run again on the file as it was saved.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace mien {

enum class JobState { waiting, running, done, failed, stopped };

struct Job {
  int id = 0;
  std::string kind, title;
  std::vector<std::string> command;
  JobState state = JobState::waiting;
  std::string stage;  // what is being counted: "frames"
  int finished = 0, all = 0;
  std::deque<std::string> lines;               // the last ones, as on a terminal
  std::vector<std::filesystem::path> results;  // files that are complete
  bool is_to_stop = false;
};

// One at a time, in the order that they were asked for: each has all the cores. Those that ended are kept,
// some of them.
struct Jobs {
  Jobs();
  ~Jobs();  // ends what runs
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  std::mutex mutex;  // of all that follows
  std::condition_variable changed;
  int version = 1;  // counts what happens
  int count = 0;
  std::deque<Job> jobs;  // the newest last
  bool is_ending = false;
  int waiting = 0;  // pages that wait for news
  std::thread worker;
};

// Its number. Throws InputError if too many are waiting.
int add_job(Jobs& jobs, const std::string& kind, const std::string& title,
            const std::vector<std::string>& command);

// Ends it, or keeps it from beginning; nothing if it has ended.
void stop_job(Jobs& jobs, int id);

// What runs is ended, and nothing more begins; wakes all who wait.
void end_jobs(Jobs& jobs);

// What a line of the program's JSON says, into the job.
void read_job_line(Job& job, const std::string& line);

}  // namespace mien
