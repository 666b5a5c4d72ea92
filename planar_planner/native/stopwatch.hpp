// Time, as those see it who may not read a clock: only planning/ reads one and hands it down.
#pragma once

#include <functional>

namespace planner {

// Seconds since some moment, the same at every call.
using Clock = std::function<double()>;

// Adds the time of its life to a total. Times never steer anything but the end of a query.
class Stopwatch {
 public:
  Stopwatch(const Clock& clock, double& total) : clock_(clock), total_(total), begin_(clock()) {}
  ~Stopwatch() { total_ += clock_() - begin_; }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  const Clock& clock_;
  double& total_;
  double begin_;
};

}  // namespace planner
