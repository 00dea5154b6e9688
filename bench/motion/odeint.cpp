#include <boost/numeric/odeint.hpp>

#include "problem.h"

namespace twrench::bench {
namespace {

namespace odeint = boost::numeric::odeint;

/// odeint takes its system by value or reference; a small struct is inlined.
template <class Form>
struct System {
  Form form;
  void operator()(const typename Form::State& y, typename Form::State& dydt, double) const {
    form.rate(y.data(), dydt.data());
  }
};

template <class Form>
Candidate fixed_rk4() {
  return {"odeint", std::string("rk4 (") + Form::name + ")", step_counts(),
          [](const Problem& problem, double steps) {
            const System<Form> system{Form(problem.body)};
            typename Form::State y = system.form.start;
            odeint::runge_kutta4<typename Form::State> stepper;
            odeint::integrate_n_steps(stepper, std::cref(system), y, 0.0, problem.t_end / steps,
                                      static_cast<std::size_t>(steps));
            return Form::attitude(y.data());
          }};
}

/// `make` takes a tolerance and returns a controlled stepper.
template <class Form, class Make>
Candidate controlled(const char* name, Make make) {
  return {"odeint", std::string(name) + " (" + Form::name + ")", tolerances(),
          [make](const Problem& problem, double tolerance) {
            const System<Form> system{Form(problem.body)};
            typename Form::State y = system.form.start;
            odeint::integrate_adaptive(make(tolerance), std::cref(system), y, 0.0, problem.t_end,
                                       0.1);
            return Form::attitude(y.data());
          }};
}

template <class Form>
void add(std::vector<Candidate>& list) {
  using State = typename Form::State;
  list.push_back(fixed_rk4<Form>());
  list.push_back(controlled<Form>("dopri5", [](double tolerance) {
    return odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<State>());
  }));
  list.push_back(controlled<Form>("fehlberg78", [](double tolerance) {
    return odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<State>());
  }));
  list.push_back(controlled<Form>("bulirsch_stoer", [](double tolerance) {
    return odeint::bulirsch_stoer<State>(tolerance, tolerance);
  }));
}

}  // namespace

std::vector<Candidate> odeint_candidates() {
  std::vector<Candidate> list;
  add<VelocityForm>(list);
  add<MomentumForm>(list);
  return list;
}

}  // namespace twrench::bench
