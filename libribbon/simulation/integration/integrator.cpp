#include "simulation/integration/integrator.h"

namespace ribbon {

std::unique_ptr<Integrator> create_integrator(IntegrationMethod method,
                                              const SpringNetwork& springs,
                                              const MotionProperties& properties) {
  switch (method) {
    case IntegrationMethod::symplectic_euler:
      return symplectic_euler(springs, properties);
    case IntegrationMethod::implicit:
      return implicit_euler(springs, properties);
    case IntegrationMethod::rk4:
      break;
  }
  return runge_kutta(springs, properties);
}

}  // namespace ribbon
