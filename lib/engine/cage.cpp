// Cages a child that runs untrusted scripts.
#include <fcntl.h>
#include <seccomp.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>

#include "engine/child.h"

namespace obby::engine {
namespace {

void limit(int resource, rlim_t max) {
  const rlimit both = {max, max};
  setrlimit(resource, &both);
}

// The system calls that a child needs, for memory, pipes and its own children.
constexpr int kAllowed[] = {SCMP_SYS(read),
                            SCMP_SYS(write),
                            SCMP_SYS(close),
                            SCMP_SYS(poll),
                            SCMP_SYS(ppoll),
                            SCMP_SYS(pipe),
                            SCMP_SYS(pipe2),
                            SCMP_SYS(clone),
                            SCMP_SYS(clone3),
                            SCMP_SYS(fork),
                            SCMP_SYS(vfork),
                            SCMP_SYS(wait4),
                            SCMP_SYS(kill),
                            SCMP_SYS(getpid),
                            SCMP_SYS(gettid),
                            SCMP_SYS(tgkill),
                            SCMP_SYS(mmap),
                            SCMP_SYS(munmap),
                            SCMP_SYS(mremap),
                            SCMP_SYS(madvise),
                            SCMP_SYS(mprotect),
                            SCMP_SYS(brk),
                            SCMP_SYS(futex),
                            SCMP_SYS(exit),
                            SCMP_SYS(exit_group),
                            SCMP_SYS(rt_sigreturn),
                            SCMP_SYS(rt_sigprocmask),
                            SCMP_SYS(rt_sigaction),
                            SCMP_SYS(clock_gettime),
                            SCMP_SYS(gettimeofday),
                            SCMP_SYS(set_robust_list),
                            SCMP_SYS(rseq),
                            SCMP_SYS(restart_syscall),
                            SCMP_SYS(setitimer),
                            SCMP_SYS(sched_yield),
                            SCMP_SYS(getrandom)};

bool allowOnly() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (filter == nullptr) return false;
  bool good = true;
  for (const int call : kAllowed)
    good = seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) == 0 && good;
  good = good && seccomp_load(filter) == 0;
  seccomp_release(filter);
  return good;
}

}  // namespace

namespace {

constexpr int kLooks = 4;  // checks within the time that a beat may take
const volatile unsigned* watched = nullptr;
unsigned lastBeat = 0;
int sameLooks = 0;

void look(int) {
  sameLooks = *watched == lastBeat ? sameLooks + 1 : 0;
  lastBeat = *watched;
  if (sameLooks >= kLooks) _exit(1);
}

}  // namespace

void watchBeat(const volatile unsigned* beat, double seconds) {
  watched = beat;
  struct sigaction action = {};
  action.sa_handler = look;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPROF, &action, nullptr);
  const auto microseconds = long(seconds / kLooks * 1e6);
  const timeval every = {microseconds / 1'000'000, microseconds % 1'000'000};
  const itimerval timer = {every, every};
  setitimer(ITIMER_PROF, &timer, nullptr);
}

bool enterCage(double seconds, size_t memory) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, rlim_t(std::ceil(seconds)) + 1);
  limit(RLIMIT_AS, memory);
  return allowOnly();
}

}  // namespace obby::engine
