// A program started by a test or a benchmark, so that it can be ended by its id.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

namespace brachium {

class OwnChild {
 public:
  // `words`: the program, found as the shell finds it, and its arguments. What it prints is lost.
  explicit OwnChild(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
    if (posix_spawnp(&pid_, arguments[0], &actions, nullptr, arguments.data(), environ) != 0)
      pid_ = -1;
    posix_spawn_file_actions_destroy(&actions);
  }
  ~OwnChild() {
    if (pid_ > 0) Kill(SIGKILL), Wait();
  }
  OwnChild(const OwnChild&) = delete;
  OwnChild& operator=(const OwnChild&) = delete;

  void Kill(int signal) const {
    if (pid_ > 0) kill(pid_, signal);
  }

  // The exit code, or 128 and the signal that ended it; 127 if it could not be started. `usage`,
  // unless null, receives what it took.
  int Wait(rusage* usage = nullptr) {
    if (pid_ < 0) return 127;
    int status = 0;
    wait4(pid_, &status, 0, usage);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  pid_t pid_ = -1;
};

}  // namespace brachium
