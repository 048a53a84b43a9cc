#include "bin/termination.h"

#include <signal.h>
#include <unistd.h>

#include <thread>

namespace brachium {
namespace {

constexpr int kSignalExit = 128;

// Never destroyed: the waiting thread outlives main().
std::mutex& Writing() {
  static auto* const mutex = new std::mutex;
  return *mutex;
}

}  // namespace

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
    _exit(kSignalExit + signal);
  }).detach();
}

}  // namespace brachium
