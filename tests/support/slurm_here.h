// A Slurm cluster of one node, this machine, on loopback: its own daemons, ports and keys, gone with
// it.
#pragma once

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/own_child.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace brachium {

class SlurmHere {
 public:
  // Why there can be none; empty where there can. Its daemons want to be root.
  static std::string WhyNot() {
    for (const char* program : {"/usr/sbin/slurmctld", "/usr/sbin/slurmd", "/usr/sbin/munged",
                                "/usr/bin/sbatch", "/usr/bin/squeue"})
      if (access(program, X_OK) != 0) return std::string(program) + " is not installed";
    return geteuid() == 0 ? "" : "only root may start slurmd";
  }

  SlurmHere() {
    chmod(folder_.path().c_str(), 0755);
    for (const char* name : {"state", "spool"}) mkdir(folder_.File(name).c_str(), 0755);
    WriteKey();
    folder_.Write("slurm.conf", Configuration());
    setenv("SLURM_CONF", folder_.File("slurm.conf").c_str(), 1);
    Start({"/usr/sbin/munged", "--force", "--socket=" + folder_.File("munge.sock"),
           "--key-file=" + folder_.File("key"), "--pid-file=" + folder_.File("munged.pid"),
           "--log-file=" + folder_.File("munged.log"), "--seed-file=" + folder_.File("seed")});
    Start({"/usr/sbin/slurmctld", "-f", folder_.File("slurm.conf"), "-c"});
    StartNode();
  }
  ~SlurmHere() {
    Said("scancel --quiet --user=root");
    WaitUntilEmpty(20);
    for (const char* daemon : {"slurmd", "slurmctld", "munged"}) Stop(daemon);
    unsetenv("SLURM_CONF");
  }
  SlurmHere(const SlurmHere&) = delete;
  SlurmHere& operator=(const SlurmHere&) = delete;

  void StartNode() const {
    Start({"/usr/sbin/slurmd", "-f", folder_.File("slurm.conf"), "-N", "localhost"});
  }
  void StopNode() const { Stop("slurmd"); }

  // Whether the node takes jobs within a minute.
  bool IsReady() const {
    return Within(60, [&] { return Said("sinfo --noheader --format=%T").starts_with("idle"); });
  }

  // What a command writes to standard output.
  static std::string Said(const std::string& command) {
    std::string text;
    FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
    for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe))
      text += static_cast<char>(letter);
    pclose(pipe);
    return text;
  }

  static bool WaitUntilEmpty(int seconds) {
    return Within(seconds, [] { return Said("squeue --noheader --format=%i").empty(); });
  }

  template <typename Condition>
  static bool Within(int seconds, const Condition& condition) {
    for (int i = 0; i < 5 * seconds; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    return false;
  }

 private:
  void WriteKey() const {
    std::random_device random;
    std::string key;
    for (int i = 0; i < 128; ++i) key += static_cast<char>(random());
    folder_.Write("key", key);
    chmod(folder_.File("key").c_str(), 0600);
  }

  // Ports by the process, so that several tests may run at a time.
  std::string Configuration() const {
    const int port = 20000 + 2 * (getpid() % 10000);
    char host[256] = {};
    gethostname(host, sizeof host - 1);
    const std::string name = std::string(host).substr(0, std::string(host).find('.'));
    std::string text = "ClusterName=test\nSlurmctldHost=localhost(127.0.0.1)\nSlurmctldPort=" +
                       std::to_string(port) + "\nSlurmdPort=" + std::to_string(port + 1) + "\n";
    for (const char* line :
         {"CommunicationParameters=NoInAddrAny,NoCtldInAddrAny", "SlurmUser=root",
          "ProctrackType=proctrack/linuxproc", "TaskPlugin=task/none",
          "JobAcctGatherType=jobacct_gather/none", "AccountingStorageType=accounting_storage/none",
          "SelectType=select/cons_tres", "SelectTypeParameters=CR_Core", "MpiDefault=none",
          "ReturnToService=2", "MaxArraySize=10001", "KillWait=5", "MinJobAge=10",
          "SchedulerParameters=sched_interval=2,bf_interval=2", "AuthType=auth/munge",
          "CredType=cred/munge"})
      text.append(line).append("\n");
    text += "AuthInfo=socket=" + folder_.File("munge.sock") + "\n";
    text += "StateSaveLocation=" + folder_.File("state") + "\n";
    text += "SlurmdSpoolDir=" + folder_.File("spool") + "\n";
    for (const std::string daemon : {"Slurmctld", "Slurmd"}) {
      const std::string file = daemon == "Slurmd" ? "slurmd" : "slurmctld";
      text += daemon + "LogFile=" + folder_.File(file + ".log") + "\n";
      text += daemon + "PidFile=" + folder_.File(file + ".pid") + "\n";
    }
    return text + "NodeName=localhost NodeHostname=" + name +
           " NodeAddr=127.0.0.1 CPUs=2 RealMemory=2000 State=UNKNOWN\n"
           "PartitionName=main Nodes=localhost Default=YES MaxTime=INFINITE State=UP\n";
  }

  static void Start(const std::vector<std::string>& words) { OwnChild(words).Wait(); }

  void Stop(const std::string& daemon) const {
    const int pid = std::atoi(folder_.Read(daemon + ".pid").c_str());
    if (pid <= 1) return;
    kill(pid, SIGTERM);
    if (!Within(15, [&] { return kill(pid, 0) != 0; })) kill(pid, SIGKILL);
  }

  TemporaryFolder folder_;
};

}  // namespace brachium
