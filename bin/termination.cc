#include "bin/termination.h"

#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <thread>

namespace brachium {
namespace {

constexpr int kSignalExit = 128;

// Never destroyed: the waiting thread outlives main().
std::mutex& Writing() {
  static auto* const mutex = new std::mutex;
  return *mutex;
}

// What to remove, under Writing(); empty: nothing.
std::string& Draft() {
  static auto* const draft = new std::string;
  return *draft;
}

void SetDraft(const std::string& folder) {
  const std::lock_guard<std::mutex> lock(Writing());
  Draft() = folder;
}

}  // namespace

DiscardedOnTermination::DiscardedOnTermination(const std::string& folder) { SetDraft(folder); }

DiscardedOnTermination::~DiscardedOnTermination() { SetDraft(""); }

WithoutInterruption::WithoutInterruption() : lock_(Writing()) {}

// A thread that waits for the signals may take a lock, which a signal handler may not.
void ExitOnTermination() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    int signal = 0;
    sigwait(&signals, &signal);
    Writing().lock();
    std::error_code ignored;
    if (!Draft().empty()) std::filesystem::remove_all(Draft(), ignored);
    _exit(kSignalExit + signal);
  }).detach();
}

}  // namespace brachium
