#include "bridge/process.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace obby::bridge {
namespace {

struct Pipe {
  OwnedFd read, write;
};

Result<Pipe> makePipe() {
  int fds[2];
  if (pipe2(fds, O_CLOEXEC) != 0)
    return makeError(std::string("cannot create a pipe: ") + strerror(errno));
  return Pipe{OwnedFd(fds[0]), OwnedFd(fds[1])};
}

// Sets a soft limit of `max`, and a hard one `slack` above it, which a program cannot catch.
void limit(decltype(RLIMIT_AS) what, uint64_t max, uint64_t slack = 0) {
  rlimit now{};
  if (max == 0 || getrlimit(what, &now) != 0) return;
  now.rlim_max = std::min<rlim_t>(now.rlim_max, max + slack);  // RLIM_INFINITY is the largest
  now.rlim_cur = std::min<rlim_t>(now.rlim_max, max);
  setrlimit(what, &now);
}

// Everything that the child needs, made before fork: between fork and exec nothing may allocate.
struct Launch {
  Launch(const Command& what, std::vector<std::string> variables)
      : command(what), environment(std::move(variables)) {
    argv.push_back(const_cast<char*>(command.path.c_str()));
    for (const std::string& text : command.arguments) {
      argv.push_back(const_cast<char*>(text.c_str()));
    }
    for (std::string& text : environment) envp.push_back(text.data());
    argv.push_back(nullptr);
    envp.push_back(nullptr);
  }
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  const Command& command;
  std::vector<std::string> environment;
  std::vector<char*> argv, envp;
  std::array<int, 3> streams{};  // become descriptors 0, 1, 2
  int failure = -1;              // errno is written here if exec fails
  pid_t parent = getpid();
};

// Returns only the variables that a program needs to run, and none that change our tools (OBBY_*).
std::vector<std::string> environment() {
  std::vector<std::string> out;
  for (const char* name : {"PATH", "HOME", "LANG", "LC_ALL", "TMPDIR", "XDG_STATE_HOME"}) {
    if (const char* value = getenv(name)) out.push_back(std::string(name) + "=" + value);
  }
  return out;
}

[[noreturn]] void runChild(const Launch& launch) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The parent may have died before prctl. Then the signal that prctl requests would never be sent.
  if (getppid() != launch.parent) _Exit(127);
  for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGCHLD, SIGXFSZ}) {
    ::signal(number, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  limit(RLIMIT_AS, launch.command.memoryBytes);
  limit(RLIMIT_CPU, launch.command.cpuSeconds, 5);  // SIGXCPU, then SIGKILL
  limit(RLIMIT_CORE, 1);
  for (int i = 0; i < 3; i++) dup2(launch.streams[size_t(i)], i);
  close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  execve(launch.command.path.c_str(), launch.argv.data(), launch.envp.data());
  const int reason = errno;
  if (write(launch.failure, &reason, sizeof reason) < 0) _Exit(126);
  _Exit(127);
}

// Moves a descriptor that is 0, 1 or 2 to a higher number, because dup2 onto these would lose it.
Status aboveStandard(OwnedFd& fd) {
  if (fd.get() > 2) return {};
  OwnedFd higher(fcntl(fd.get(), F_DUPFD_CLOEXEC, 3));
  if (higher.get() < 0)
    return makeError(std::string("cannot copy a file descriptor: ") + strerror(errno));
  fd = std::move(higher);
  return {};
}

// Makes the call by number, because Debian 12's C library declares it without extern "C".
int openPid(pid_t pid) { return int(syscall(SYS_pidfd_open, pid, 0)); }

void reapNow(pid_t pid) {
  while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace

Process::Process(Process&& other) noexcept
    : input(std::move(other.input)),
      output(std::move(other.output)),
      errors(std::move(other.errors)),
      pid_(std::exchange(other.pid_, 0)),
      exitFd_(std::move(other.exitFd_)) {}

Process::~Process() {
  if (pid_ == 0) return;
  signal(SIGKILL);
  reapNow(pid_);
}

Result<Process> Process::start(const Command& command) {
  OBBY_ASSIGN(Pipe in, makePipe());
  OBBY_ASSIGN(Pipe out, makePipe());
  OBBY_ASSIGN(Pipe err, makePipe());
  OBBY_ASSIGN(Pipe failure, makePipe());
  for (OwnedFd* fd : {&in.read, &out.write, &err.write, &failure.write}) {
    OBBY_RETURN_IF_ERROR(aboveStandard(*fd));
  }
  Launch launch(command, environment());
  launch.streams = {in.read.get(), out.write.get(), err.write.get()};
  launch.failure = failure.write.get();

  Process process;
  process.pid_ = fork();
  if (process.pid_ == 0) runChild(launch);
  if (process.pid_ < 0) {
    process.pid_ = 0;
    return makeError(command.path + ": cannot start: " + strerror(errno));
  }
  setpgid(process.pid_, process.pid_);  // here, too: a signal may come before the child's own call
  failure.write = OwnedFd();
  int reason = 0;
  ssize_t n = 0;
  while ((n = read(failure.read.get(), &reason, sizeof reason)) < 0 && errno == EINTR) {
  }
  if (n > 0) return makeError(command.path + ": cannot start: " + strerror(reason));
  process.exitFd_ = OwnedFd(openPid(process.pid_));
  if (process.exitFd_.get() < 0) {
    return makeError(std::string("cannot watch a program: ") + strerror(errno),
                     "use Linux 5.9 or newer");
  }
  process.input = std::move(in.write);
  process.output = std::move(out.read);
  process.errors = std::move(err.read);
  return process;
}

double Process::cpuSeconds() const {
  clockid_t own{};
  timespec used{};
  if (pid_ <= 0 || clock_getcpuclockid(pid_, &own) != 0 || clock_gettime(own, &used) != 0) return 0;
  return double(used.tv_sec) + double(used.tv_nsec) * 1e-9;
}

void Process::signal(int number) const {
  if (pid_ > 0) kill(-pid_, number);
}

Exit Process::reap() {
  signal(SIGKILL);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = 0;
  if (WIFSIGNALED(status)) return {0, WTERMSIG(status)};
  return {WEXITSTATUS(status), 0};
}

}  // namespace obby::bridge
