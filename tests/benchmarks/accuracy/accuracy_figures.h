// How far runs by one setting are from the converged ones.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/accuracy/accuracy_run.h"
#include "benchmarks/accuracy/accuracy_settings.h"

namespace ribbon {

struct AccuracyRuns {
  AccuracyRun before_contact;
  std::vector<AccuracyRun> fastenings;  // from slightly different starts
};

struct Measured {
  double mean = 0;
  double spread = 0;  // standard deviation over the starts; 0 of a single one
};

struct AccuracyFigures {
  std::string name;
  bool is_level = false;
  double processor_s = 0;  // per simulated second of the fastenings
  // Before contact: distance of the particles from the converged ones, over the way that those
  // went, root mean squares.
  double before_contact = 0;
  // After it particles are not comparable: likewise of the ends alone, over the whole fastening,
  // their paths averaged over the starts. The spread is that of the mean.
  Measured after_contact;
  Measured tight_s;
  Measured rope_length;
  Measured ends_apart_m;
  double worst_strain = 0;  // in contact
  double energy = 0;
};

AccuracyFigures figures_of(const AccuracySetting& setting, const AccuracyRuns& runs,
                           const AccuracyRuns& converged);

// Is `a` faster than `b` and nowhere less accurate, by more than what one run differs from the
// next?
bool beats(const AccuracyFigures& a, const AccuracyFigures& b);

}  // namespace ribbon
