// What one time step brought about.
#pragma once

namespace ribbon {

struct StepReport {
  int recovery_iterations = 0;  // of Figure 15: how often scheme A, B or C was applied
  int penetrating_edges = 0;    // left over, of ribbon and obstacle; none with the gate
  int truncated = 0;            // particles that the gate did not let reach their targets
  double pull = 1;              // the fraction of the fastening force that the hands applied
  bool is_bearable = true;      // with the gate: is every edge within the paper's limit of strain?
  // Is some edge still noticeably longer or shorter than the strain correction aims at?
  bool is_over_aimed = false;
};

}  // namespace ribbon
