// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/surrogate/minimize.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cassert>
#include <exception>
#include <limits>
#include <memory>

namespace corticle::fit
{

namespace
{

/// Of NLopt's names, those of methods that need neither derivatives nor a second method.
bool is_usable(const std::string& name)
{
    return (name.starts_with("LN_") || name.starts_with("GN_")) && name.find("AUGLAG") == std::string::npos &&
           name.find("MLSL") == std::string::npos && name != "GN_AGS";
}

/// The others may run beside each other.
bool draws_numbers(const std::string& name)
{
    return name.starts_with("GN_") || name == "LN_PRAXIS";
}

/// What NLopt calls, and what became of it.
struct Call
{
    const Objective& function;
    nlopt_opt search;
    Minimum best;
    std::exception_ptr thrown;
};

double evaluate(unsigned count, const double* at, double*, void* data)
{
    Call& call = *static_cast<Call*>(data);
    try
    {
        const double value = call.function({at, count});
        if (value < call.best.value)
        {
            call.best = {{at, at + count}, value};
        }
        return value;
    }
    catch (...) // no exception may pass through NLopt's C
    {
        call.thrown = std::current_exception();
        nlopt_force_stop(call.search);
        return std::numeric_limits<double>::max();
    }
}

} // namespace

std::vector<std::string> method_names()
{
    std::vector<std::string> names;
    for (int i = 0; i < NLOPT_NUM_ALGORITHMS; ++i)
    {
        const std::string name = nlopt_algorithm_to_string(static_cast<nlopt_algorithm>(i));
        if (is_usable(name))
        {
            names.push_back(name);
        }
    }
    std::ranges::sort(names);
    return names;
}

std::string find_method(const std::string& name)
{
    std::string wanted;
    for (const char c : name)
    {
        wanted +=
            c == '-' || c == ' ' ? "" : std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
    }
    wanted = wanted == "CRS" ? "CRS2_LM" : wanted;
    const std::vector<std::string> names = method_names();
    const auto found = std::ranges::find_if(names, [&](const std::string& known)
                                            { return known == wanted || known.substr(3) == wanted; });
    return found == names.end() ? "" : *found;
}

Minimum minimize(const Objective& function, std::span<const double> start, const Minimization& how)
{
    assert(!find_method(how.method).empty());
    const nlopt_algorithm algorithm = nlopt_algorithm_from_string(find_method(how.method).c_str());
    const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(
        nlopt_create(algorithm, static_cast<unsigned>(start.size())), nlopt_destroy);
    Call call{function, search.get(), {{start.begin(), start.end()}, std::numeric_limits<double>::infinity()}, nullptr};
    if (draws_numbers(find_method(how.method)))
    {
        nlopt_srand(static_cast<unsigned long>(how.seed));
    }
    nlopt_set_min_objective(search.get(), evaluate, &call);
    nlopt_set_lower_bounds1(search.get(), 0.0);
    nlopt_set_upper_bounds1(search.get(), 1.0);
    nlopt_set_xtol_abs1(search.get(), how.tolerance);
    nlopt_set_maxeval(search.get(), how.evaluations);
    nlopt_set_initial_step1(search.get(), how.step);
    std::vector<double> at(start.begin(), start.end());
    double value = 0.0;
    nlopt_optimize(search.get(), at.data(), &value); // whatever it says: the best that was seen counts
    if (call.thrown)
    {
        std::rethrow_exception(call.thrown);
    }
    return call.best;
}

} // namespace corticle::fit
