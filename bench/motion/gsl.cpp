#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <memory>

#include "problem.h"

namespace twrench::bench {
namespace {

template <class Form>
int rate(double, const double* y, double* dydt, void* form) {
  static_cast<const Form*>(form)->rate(y, dydt);
  return GSL_SUCCESS;
}

template <class Form>
Candidate candidate(const char* name, const gsl_odeiv2_step_type* type) {
  return {"GSL", std::string(name) + " (" + Form::name + ")", tolerances(),
          [type](const Problem& problem, double tolerance) {
            Form form(problem.body);
            typename Form::State y = form.start;
            gsl_odeiv2_system system{rate<Form>, nullptr, Form::size, &form};
            const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
                gsl_odeiv2_driver_alloc_y_new(&system, type, 0.1, tolerance, tolerance),
                &gsl_odeiv2_driver_free);
            double t = 0;
            if (gsl_odeiv2_driver_apply(driver.get(), &t, problem.t_end, y.data()) != GSL_SUCCESS) {
              y.fill(std::numeric_limits<double>::quiet_NaN());
            }
            return Form::attitude(y.data());
          }};
}

}  // namespace

std::vector<Candidate> gsl_candidates() {
  gsl_set_error_handler_off();
  return {candidate<VelocityForm>("rk8pd", gsl_odeiv2_step_rk8pd),
          candidate<MomentumForm>("rk8pd", gsl_odeiv2_step_rk8pd)};
}

}  // namespace twrench::bench
