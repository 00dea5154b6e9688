#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>
#include <sundials/sundials_context.hpp>

#include "problem.h"

namespace twrench::bench {
namespace {

constexpr long most_steps = 100'000;  // more would take too long to be useful

/// One per program, because creating it is not part of an integration.
SUNContext context() {
  static const sundials::Context the_context;
  return the_context;
}

template <class Form>
int rate(double, N_Vector y, N_Vector dydt, void* form) {
  static_cast<const Form*>(form)->rate(N_VGetArrayPointer(y), N_VGetArrayPointer(dydt));
  return 0;
}

struct DestroyVector {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, DestroyVector>;

template <class Form>
Vector initial(const Form& form) {
  Vector y(N_VNew_Serial(Form::size, context()));
  std::ranges::copy(form.start, N_VGetArrayPointer(y.get()));
  return y;
}

/// The attitude if the solver reached its end, otherwise NaN.
template <class Form>
Eigen::Matrix3d result(int flag, const Vector& y) {
  if (flag < 0) return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return Form::attitude(N_VGetArrayPointer(y.get()));
}

template <class Form>
Eigen::Matrix3d cvode_adams(const Problem& problem, double tolerance) {
  Form form(problem.body);
  const Vector y = initial(form);
  void* memory = CVodeCreate(CV_ADAMS, context());
  CVodeInit(memory, rate<Form>, 0, y.get());
  CVodeSStolerances(memory, tolerance, tolerance);
  CVodeSetUserData(memory, &form);
  CVodeSetMaxNumSteps(memory, most_steps);
  CVodeSetErrHandlerFn(
      memory, [](int, const char*, const char*, char*, void*) {}, nullptr);
  CVodeSetStopTime(memory, problem.t_end);
  SUNNonlinearSolver solver = SUNNonlinSol_FixedPoint(y.get(), 0, context());
  CVodeSetNonlinearSolver(memory, solver);
  double t = 0;
  const int flag = CVode(memory, problem.t_end, y.get(), &t, CV_NORMAL);
  SUNNonlinSolFree(solver);
  CVodeFree(&memory);
  return result<Form>(flag, y);
}

template <class Form>
Eigen::Matrix3d arkode_erk(const Problem& problem, double tolerance, int order) {
  Form form(problem.body);
  const Vector y = initial(form);
  void* memory = ERKStepCreate(rate<Form>, 0, y.get(), context());
  ERKStepSetOrder(memory, order);
  ERKStepSStolerances(memory, tolerance, tolerance);
  ERKStepSetUserData(memory, &form);
  ERKStepSetMaxNumSteps(memory, most_steps);
  ERKStepSetErrHandlerFn(
      memory, [](int, const char*, const char*, char*, void*) {}, nullptr);
  ERKStepSetStopTime(memory, problem.t_end);
  double t = 0;
  const int flag = ERKStepEvolve(memory, problem.t_end, y.get(), &t, ARK_NORMAL);
  ERKStepFree(&memory);
  return result<Form>(flag, y);
}

template <class Form>
void add(std::vector<Candidate>& list) {
  list.push_back(
      {"SUNDIALS", fmt::format("CVODE Adams ({})", Form::name), tolerances(), cvode_adams<Form>});
  for (const int order : {4, 5, 6, 8}) {
    list.push_back({"SUNDIALS", fmt::format("ARKODE ERK order {} ({})", order, Form::name),
                    tolerances(), [order](const Problem& problem, double tolerance) {
                      return arkode_erk<Form>(problem, tolerance, order);
                    }});
  }
}

}  // namespace

std::vector<Candidate> sundials_candidates() {
  std::vector<Candidate> list;
  add<VelocityForm>(list);
  add<MomentumForm>(list);
  return list;
}

}  // namespace twrench::bench
