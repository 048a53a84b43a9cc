#include "bin/compare_pair.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "bin/flags.h"
#include "bin/in_parallel.h"
#include "bin/judge.h"
#include "bin/progress_line.h"
#include "bin/run_facts.h"
#include "bin/run_info.h"
#include "bin/termination.h"
#include "io/estimate_folder.h"
#include "io/evaluation_file.h"
#include "io/input_error.h"
#include "io/trial_folder.h"

namespace brachium {
namespace {

using Outcome = ComparedPair::Outcome;

std::vector<NameValue> FlagsOf(const PairTask& task) {
  std::vector<NameValue> flags = {{"trial", task.trial.path}, {"method", task.method}};
  std::visit(
      [&](const auto& options) {
        options.Visit(options, [&](const char* name, const auto& value, const char*) {
          flags.emplace_back(name, Text(FlagValue(value)));
        });
      },
      task.options);
  return flags;
}

void Run(const PairTask& task, const TrialFolder& folder, const RunInfo& run) {
  const Estimate estimate = MakeEstimator(task.options)->Run(folder.trial.observations);
  const WithoutInterruption writing;
  WriteEstimate(task.estimate, estimate, run, task.overwrite);
}

std::string WhyNotTrusted(const Diagnostics& diagnostics) {
  const std::string what =
      diagnostics.singular ? "the information matrix is singular" : "not converged";
  return diagnostics.termination.empty() ? what : what + "; " + diagnostics.termination;
}

bool SharesAnything(const Estimate& estimate, const Reference& reference) {
  const auto in = [](const auto& map) {
    return [&map](const auto& item) { return map.contains(item.first); };
  };
  return std::any_of(estimate.q_WB.begin(), estimate.q_WB.end(), in(reference.q_VB)) ||
         std::any_of(estimate.p_W.begin(), estimate.p_W.end(), in(reference.p_V));
}

// From the files, so that an estimate found there and one made now are judged alike.
void JudgeWritten(const PairTask& task, const Reference& reference, ComparedPair* pair) {
  const Estimate estimate = ReadEstimate(task.estimate);
  if (!SharesAnything(estimate, reference)) {
    pair->outcome = Outcome::kRefused;
    pair->reason = "the method tells nothing that the reference of this trial knows";
    return;
  }
  pair->evaluation = Judge(estimate, reference, task.trial.path);
  pair->trusted = estimate.diagnostics.converged && !estimate.diagnostics.singular;
  if (!pair->trusted) pair->reason = WhyNotTrusted(estimate.diagnostics);
  const WithoutInterruption writing;
  WriteEvaluation(task.estimate, pair->evaluation, task.overwrite);
}

void EstimateAndJudge(const PairTask& task, const TrialFolder& folder, double reading_seconds,
                      ComparedPair* pair) {
  if (!MakeEstimator(task.options)->Accepts(folder.trial.observations, &pair->reason)) {
    pair->outcome = Outcome::kRefused;
    return;
  }
  const RunInfo run =
      RunInfoOf(folder, task.options, FlagsOf(task), task.command_line, reading_seconds);
  pair->reused = HoldsEstimate(task.estimate, task.method, run);
  if (!pair->reused) {
    CheckReplaceable(task.estimate, EstimateFolderKind(), task.overwrite);
    Run(task, folder, run);
  }
  JudgeWritten(task, *folder.trial.reference, pair);
}

}  // namespace

ComparedPair RunPair(const PairTask& task) {
  const Stopwatch watch;
  ComparedPair pair{.trial = task.trial.name, .method = task.method};
  const auto fail = [&](Outcome outcome, const std::string& reason) {
    pair.outcome = outcome;
    pair.reason = reason;
    pair.evaluation = {};
  };
  try {
    const TrialFolder folder = ReadTrial(task.trial.path);
    RequireReference(folder, task.trial.path);
    EstimateAndJudge(task, folder, watch.Seconds(), &pair);
  } catch (const OutputError&) {
    throw;
  } catch (const InputError& error) {
    fail(Outcome::kUnreadable, error.what());
  } catch (const std::bad_alloc&) {
    fail(Outcome::kFailed, "there is not enough memory; try fewer --threads");
  } catch (const std::exception& error) {
    fail(Outcome::kFailed, error.what());
  }
  pair.seconds = watch.Seconds();
  return pair;
}

std::vector<ComparedPair> RunPairs(const std::vector<PairTask>& tasks, int threads) {
  std::vector<ComparedPair> pairs(tasks.size());
  ProgressLine line;
  const Progress progress = line.callback();
  std::mutex mutex;
  std::size_t done = 0;
  InParallel(tasks.size(), threads, [&](std::size_t i) {
    pairs[i] = RunPair(tasks[i]);
    const std::lock_guard lock(mutex);
    ++done;
    if (progress)
      progress(std::to_string(done) + " of " + std::to_string(tasks.size()) + ": " +
                   tasks[i].method + " on " + tasks[i].trial.name,
               static_cast<double>(done) / static_cast<double>(tasks.size()));
  });
  return pairs;
}

}  // namespace brachium
