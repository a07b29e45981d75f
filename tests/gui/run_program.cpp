#include "tests/gui/run_program.h"

#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/temporary_folder.h"

namespace glint::test {
namespace {

void redirect(const std::filesystem::path& file, int descriptor, int flags) {
  const int opened = ::open(file.c_str(), flags, 0600);
  ::dup2(opened, descriptor);
  ::close(opened);
}

}  // namespace

ProgramRun run_glintscope(const std::vector<std::string>& arguments, const RunOptions& options) {
  const TemporaryFolder folder;
  std::ofstream(folder / "in") << options.input;
  std::vector<std::string> words = {GLINTSCOPE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    redirect(folder / "in", STDIN_FILENO, O_RDONLY);
    redirect(folder / "out", STDOUT_FILENO, O_WRONLY | O_CREAT);
    redirect(folder / "err", STDERR_FILENO, O_WRONLY | O_CREAT);
    for (const std::string& setting : options.environment) ::putenv(::strdup(setting.c_str()));
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  auto interrupted = begin;
  if (options.interrupt_after > 0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(options.interrupt_after));
    interrupted = std::chrono::steady_clock::now();
    ::kill(child, SIGINT);
  }
  int state = 0;
  ::waitpid(child, &state, 0);
  ProgramRun run;
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - interrupted).count();
  run.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  run.out = text_of(folder / "out");
  run.err = text_of(folder / "err");
  return run;
}

}  // namespace glint::test
