// The trick of a descriptor that is open the wrong way round is gnulib's (stdopen): whoever writes is told.
#include "core/streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace mien {

void open_missing_streams() {
  for (const int descriptor : {0, 1, 2})
    // The lowest free number is the one that is given: those below it are open by now.
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
      static_cast<void>(::open("/dev/null", O_RDONLY));  // not kept from children, which have their own
}

void write_stream(std::FILE* stream, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fflush(stream);
}

void flush_stream(std::FILE* stream) {
  if (std::fflush(stream) != 0) throw std::system_error(errno, std::generic_category());
}

bool has_lost_text(std::FILE* stream) { return std::fflush(stream) != 0 || std::ferror(stream) != 0; }

}  // namespace mien
