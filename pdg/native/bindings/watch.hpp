// The clock of one call, which also lets Python handle signals, so that Ctrl-C ends a long search.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>

namespace pdg::python {

// A search that runs without the interpreter's lock asks over() between its steps.
class Watch {
 public:
  explicit Watch(const double timeout) : timeout_(timeout) {}

  // Starts the timeout, in seconds, anew.
  void begin() { begin_ = Clock::now(); }

  // Whether the timeout has passed. Throws if a signal's handler in Python does.
  bool over() {
    const Clock::time_point now = Clock::now();
    if (now - last_signals_ > kBetweenSignals) {
      last_signals_ = now;
      const nanobind::gil_scoped_acquire acquire;
      if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
    }
    return std::chrono::duration<double>(now - begin_).count() >= timeout_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kBetweenSignals{50};  // taking the lock costs a switch
  double timeout_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_signals_ = begin_;
};

}  // namespace pdg::python
