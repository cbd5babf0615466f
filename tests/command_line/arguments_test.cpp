#include "command_line/arguments.hpp"

#include <gtest/gtest.h>

#include "command_line/help.hpp"
#include "commands/table.hpp"
#include "core/error.hpp"

namespace mien {
namespace {

Request read(std::vector<const char*> words) {
  words.insert(words.begin(), "mien");
  return read_arguments(static_cast<int>(words.size()), words.data());
}

// The messages of a wrong command line, one a line.
std::string read_mistakes(const std::vector<const char*>& words) {
  try {
    read(words);
  } catch (const InputError& e) {
    std::string text;
    for (const Diagnostic& diagnostic : e.diagnostics) text += diagnostic.message + "\n";
    return text;
  }
  return "none";
}

TEST(arguments, name_a_command_and_its_file) {
  const Request request = read({"render", "configs/hello.yaml"});
  EXPECT_EQ(request.command, find_command("render"));
  EXPECT_EQ(request.options.file, "configs/hello.yaml");
  EXPECT_FALSE(request.options.output || request.options.frames || request.options.size_px);
  EXPECT_FALSE(request.options.quality || request.options.at_s || request.options.express);
  EXPECT_EQ(request.options.jobs, 0);
}

TEST(arguments, ask_for_an_stl_unless_they_say_no) {
  EXPECT_TRUE(read({"bust", "a.yaml"}).options.has_stl);
  EXPECT_FALSE(read({"bust", "a.yaml", "--no-stl"}).options.has_stl);
}

TEST(arguments, set_every_option) {
  const Options options = read({"render", "a.yaml", "-o", "there", "--frames", "10-20", "--size", "240x300",
                                "--quality", "draft", "--jobs", "3", "--quiet", "--json"})
                              .options;
  EXPECT_EQ(options.output, "there");
  EXPECT_EQ(options.frames, std::pair(10, 20));
  EXPECT_EQ(options.size_px, std::pair(240, 300));
  EXPECT_EQ(options.quality, Quality::draft);
  EXPECT_EQ(options.jobs, 3);
  EXPECT_TRUE(options.is_quiet && options.is_json);
}

TEST(arguments, set_the_options_of_stills_and_meshes) {
  const Options still = read({"still", "a.yaml", "--at=1.25s", "--angle", "-30deg", "-oface.png"}).options;
  EXPECT_EQ(still.at_s, 1.25);
  EXPECT_EQ(still.camera_angle_deg, -30);
  EXPECT_EQ(still.output, "face.png");
  const Options mesh = read({"mesh", "a.yaml", "--express", "smile", "--landmarks", "face.json"}).options;
  EXPECT_EQ(mesh.express, "smile");
  EXPECT_EQ(mesh.landmarks, "face.json");
}

TEST(arguments, set_how_a_cluster_renders) {
  const FarmOptions none = read({"render", "a.yaml"}).options.farm;
  EXPECT_EQ(none.engine, Engine::local);
  EXPECT_TRUE(none.has_wait && !none.is_dry_run && !none.part && !none.is_gathering);
  EXPECT_EQ(read({"render", "a.yaml", "--engine", "local"}).options.farm.engine, Engine::local);
  const auto read_farm = [](std::vector<const char*> words) {
    words.insert(words.begin(), {"render", "a.yaml", "--engine", "slurm"});
    return read(words).options.farm;
  };
  const FarmOptions farm =
      read_farm({"--partition", "long,short", "--chunk", "5m", "--time", "2h", "--no-wait"});
  EXPECT_EQ(farm.engine, Engine::slurm);
  EXPECT_EQ(farm.partition, "long,short");
  EXPECT_EQ(farm.chunk_s, 300);
  EXPECT_EQ(farm.time_limit, "2:00:00");
  EXPECT_FALSE(farm.has_wait);
  EXPECT_EQ(read_farm({"--chunk", "20"}).chunk_drawings, 20);
  EXPECT_EQ(read_farm({"--chunk", "90s"}).chunk_s, 90);
  EXPECT_TRUE(read_farm({"--dry-run"}).is_dry_run);
  EXPECT_EQ(read_farm({"--time", "90s"}).time_limit, "0:01:30");
  for (const char* time : {"30", "30:00", "2:00:00", "1-12", "1-12:00", "1-12:00:00"})
    EXPECT_EQ(read_farm({"--time", time}).time_limit, time);
  EXPECT_EQ(read({"render", "a.yaml", "--part", "3/8"}).options.farm.part, std::pair(3, 8));
  EXPECT_TRUE(read({"render", "a.yaml", "--part", "gather"}).options.farm.is_gathering);
}

TEST(arguments, tell_what_no_cluster_understands) {
  const auto read_wrong = [](std::vector<const char*> words) {
    words.insert(words.begin(), {"render", "a", "--engine", "slurm"});
    return read_mistakes(words);
  };
  EXPECT_EQ(read_mistakes({"render", "a", "--engine", "slum"}),
            "--engine: 'slum' is not local or slurm; did you mean 'slurm'?\n");
  for (const char* chunk : {"0", "5x", "m", "-5m", "0s", "1.5m", "99999h"})
    EXPECT_EQ(read_wrong({"--chunk", chunk}),
              "--chunk: '" + std::string(chunk) +
                  "' is not a time such as 5m or 90s, nor a number of drawings such as 20\n");
  for (const char* time : {"0", "soon", "1-", "1:2:3:4", "5x", "-1", "0:00:00", "1-1:2:3:4"})
    EXPECT_EQ(read_wrong({"--time", time}),
              "--time: '" + std::string(time) + "' is not a time such as 30m, 2h or 1-12:00:00\n");
  EXPECT_EQ(read_wrong({"--partition", "a b"}), "--partition: 'a b' is not the name of a partition\n");
  for (const char* part : {"0/3", "4/3", "3", "/", "1/", "all"})
    EXPECT_EQ(read_mistakes({"render", "a", "--part", part}),
              "--part: '" + std::string(part) + "' is not a part such as 3/8, nor the word gather\n");
  EXPECT_EQ(read_mistakes({"render", "a", "--chunk", "5m", "--dry-run"}),
            "--chunk is for --engine slurm alone; give both or neither\n"
            "--dry-run is for --engine slurm alone; give both or neither\n");
  EXPECT_EQ(read_mistakes({"render", "a", "--engine", "local", "--no-wait"}),
            "--no-wait is for --engine slurm alone; give both or neither\n");
  EXPECT_EQ(read_wrong({"--part", "1/2"}),
            "--part is what the tasks of --engine slurm run; give one of them\n");
  EXPECT_EQ(read_wrong({"--no-wait", "--dry-run"}),
            "--dry-run submits nothing that --no-wait could leave; give one of them\n");
}

TEST(arguments, may_say_a_single_frame_and_a_time_without_unit) {
  EXPECT_EQ(read({"frames", "a", "--frames", "7"}).options.frames, std::pair(7, 7));
  EXPECT_EQ(read({"still", "a", "--at", "2"}).options.at_s, 2);
  EXPECT_EQ(read({"still", "a", "--at", "500ms"}).options.at_s, 0.5);
  EXPECT_EQ(read({"still", "a", "--at", "36f"}).options.at_frames, 36);
  EXPECT_FALSE(read({"still", "a", "--at", "36f"}).options.at_s);
}

TEST(arguments, give_list_a_kind_and_new_a_name_even_a_commands) {
  EXPECT_EQ(read({"list", "ages"}).options.kind, "ages");
  EXPECT_TRUE(read({"--json", "list", "ages"}).options.is_json);
  const Request request = read({"new", "render"});
  EXPECT_EQ(request.command, find_command("new"));
  EXPECT_EQ(request.options.file, "render");
}

TEST(arguments, give_sheet_a_kind_and_a_file) {
  const Request request = read({"sheet", "views", "a.yaml", "--size", "240x300"});
  EXPECT_EQ(request.command, find_command("sheet"));
  EXPECT_EQ(request.options.kind, "views");
  EXPECT_EQ(request.options.file, "a.yaml");
  EXPECT_EQ(request.options.size_px, std::pair(240, 300));
  const std::string needs =
      "'mien sheet' needs a KIND and a FILE, as in: mien sheet views configs/hello.yaml\n";
  EXPECT_EQ(read_mistakes({"sheet"}), needs);
  EXPECT_EQ(read_mistakes({"sheet", "views"}), needs);
  EXPECT_EQ(read({"sheet", "heads", "a.yaml", "--express", "sly"}).options.express, "sly");
  EXPECT_EQ(read_mistakes({"sheet", "views", "a", "b"}), "'b' is one word too many for 'mien sheet'\n");
}

TEST(arguments, give_line_drawings_what_they_show) {
  const Request request = read({"sheet", "wire", "a.yaml", "--cage", "--guides", "--express", "sly"});
  EXPECT_EQ(request.options.kind, "wire");
  EXPECT_TRUE(request.options.wire.has_cage && request.options.wire.has_guides);
  EXPECT_FALSE(request.options.wire.has_limits || request.options.wire.is_on);
  EXPECT_TRUE(read({"still", "a.yaml", "--wire", "--limits"}).options.wire.is_on);
}

TEST(arguments, give_compare_two_files) {
  const Request request = read({"sheet", "compare", "a.yaml@smile", "b.yaml@1.2s"});
  EXPECT_EQ(request.options.file, "a.yaml@smile");
  EXPECT_EQ(request.options.other, "b.yaml@1.2s");
  const std::string needs =
      "'mien sheet compare' needs two FILEs, as in: mien sheet compare anna.yaml@smile otto.yaml\n";
  EXPECT_EQ(read_mistakes({"sheet", "compare"}), needs);
  EXPECT_EQ(read_mistakes({"sheet", "compare", "a.yaml"}), needs);
  EXPECT_EQ(read_mistakes({"sheet", "compare", "a", "b", "c"}),
            "'c' is one word too many for 'mien sheet'\n");
}

TEST(arguments, give_people_a_seed_and_no_file) {
  const Request request = read({"sheet", "people"});
  EXPECT_EQ(request.options.kind, "people");
  EXPECT_TRUE(request.options.file.empty());
  EXPECT_FALSE(request.options.seed);
  EXPECT_EQ(read({"sheet", "people", "--seed", "13"}).options.seed, 13);
  EXPECT_EQ(read({"sheet", "people", "a.yaml"}).options.file, "a.yaml");
  EXPECT_EQ(read_mistakes({"sheet", "people", "--seed", "-3"}),
            "--seed: '-3' is not a whole number within 0..1000000000\n");
  EXPECT_EQ(read({"new", "otto", "--random-head", "7"}).options.random_head, 7);
  EXPECT_FALSE(read({"new", "otto"}).options.random_head);
  EXPECT_EQ(read_mistakes({"new", "otto", "--random-head", "seven"}),
            "--random-head: 'seven' is not a whole number within 0..1000000000\n");
  EXPECT_EQ(read_mistakes({"new", "otto", "--random-haed", "7"}),
            "unknown option '--random-haed' of 'mien new'; did you mean '--random-head'?\n");
}

TEST(arguments, ask_for_texts) {
  EXPECT_EQ(read({"--version"}).text, "mien 0.1.0\n");
  EXPECT_EQ(read({"--version"}).command, nullptr);
  EXPECT_FALSE(read({"--version"}).is_usage);
  EXPECT_TRUE(read({}).is_usage);
  EXPECT_EQ(read({}).text, build_usage());
  EXPECT_EQ(read({"-h"}).text, build_help());
  EXPECT_EQ(read({"help"}).text, build_help());
  EXPECT_EQ(read({"still", "--help"}).text, build_command_help(*find_command("still")));
  EXPECT_EQ(read({"help", "still"}).text, read({"still", "-h"}).text);
}

TEST(arguments, suggest_the_command_or_option_that_was_meant) {
  EXPECT_EQ(read_mistakes({"rendr", "x"}), "unknown command 'rendr'; did you mean 'render'?\n");
  EXPECT_EQ(read_mistakes({"frobnicate"}), "unknown command 'frobnicate'\n");
  EXPECT_EQ(read_mistakes({"render", "a", "--sze", "48x60"}),
            "unknown option '--sze' of 'mien render'; did you mean '--size'?\n");
  EXPECT_EQ(read_mistakes({"render", "a", "--sze=48x60", "-x"}),
            "unknown option '--sze' of 'mien render'; did you mean '--size'?\nunknown option '-x' of 'mien "
            "render'\n");
  EXPECT_EQ(read_mistakes({"--verison"}), "unknown option '--verison'; did you mean '--version'?\n");
  EXPECT_EQ(read_mistakes({"--size", "48x60", "render", "a"}),
            "option '--size' belongs after the command's name\n");
}

TEST(arguments, say_which_word_is_missing_or_too_many) {
  EXPECT_EQ(read_mistakes({"check"}), "'mien check' needs a FILE, as in: mien check configs/hello.yaml\n");
  EXPECT_EQ(read_mistakes({"list"}), "'mien list' needs a KIND, as in: mien list expressions\n");
  EXPECT_EQ(read_mistakes({"check", "a", "b"}), "'b' is one word too many for 'mien check'\n");
  EXPECT_EQ(read_mistakes({"schema", "a"}), "'a' is one word too many for 'mien schema'\n");
  EXPECT_EQ(read_mistakes({"still", "a", "--at"}), "--at: 1 required TIME missing\n");
}

TEST(arguments, tell_every_wrong_value_at_once) {
  EXPECT_EQ(
      read_mistakes({"render", "a", "--size", "4x60", "--quality", "god", "--jobs", "0", "--frames", "9-3"}),
      "--frames: '9-3' is not a range of frames such as 10-20, counted from 1\n"
      "--jobs: '0' is not a whole number within 1..1024\n"
      "--quality: 'god' is not sketch, draft, good or best; did you mean 'good'?\n"
      "--size: '4x60' has a side outside 16..8192 pixels\n");
  EXPECT_EQ(read_mistakes({"still", "a", "--angle", "left"}),
            "--angle: 'left' is not an angle in degrees such as 30\n");
  EXPECT_EQ(read_mistakes({"still", "a", "--at", "1e999"}),
            "--at: '1e999' is not a time such as 1.2s, 500ms or 36f\n");
  EXPECT_EQ(read_mistakes({"still", "a", "--at", "-1"}),
            "--at: '-1' is not a time such as 1.2s, 500ms or 36f\n");
  EXPECT_EQ(read_mistakes({"still", "a", "--at", "nan"}),
            "--at: 'nan' is not a time such as 1.2s, 500ms or 36f\n");
  EXPECT_EQ(read_mistakes({"render", "a", "--size", "480x600px"}),
            "--size: '480x600px' is not a size such as 480x600\n");
  EXPECT_EQ(read_mistakes({"render", "a", "-o", ""}), "--output: '' is empty\n");
  EXPECT_EQ(read_mistakes({"mesh", "a", "--at", "1", "--express", "smile"}),
            "--at and --express ask for two things; give one of them\n");
}

TEST(commands, are_all_told_by_the_help) {
  const std::string help = build_help();
  for (const CommandInfo* command : kCommands) {
    EXPECT_NE(help.find("\n  " + std::string(command->name) + " "), std::string::npos) << command->name;
    EXPECT_NE(help.find("\n" + std::string(command->group) + "\n"), std::string::npos) << command->group;
    EXPECT_EQ(find_command(command->name), command);
    EXPECT_NE(command->run, nullptr) << command->name;
    for (const OptionInfo* option : list_options(*command)) {
      ASSERT_NE(option, nullptr) << command->name << ": " << command->options;
      EXPECT_NE(build_command_help(*command).find("--" + std::string(option->name)), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace mien
