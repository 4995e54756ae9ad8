// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/response.hpp"

#include "corticle/base/dual.hpp"
#include "corticle/base/wide_group.hpp"
#include "corticle/material/neo_hookean.hpp"
#include "material/mooney_rivlin.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

// One function, whatever numbers it is given: double is held against float, eight lanes and derivatives.

namespace corticle
{
namespace
{

/// A deformed and grown material point, its numbers in any precision.
template <RealLike Real>
struct Situation
{
    material::BasicMaterialPoint<Real> point;
    BasicVec3<Real> normal;
    BasicMat3<Real> F;
};

/// Number `k` of some situations: growth in and across the plane, moving moduli, and volumes down into the barrier.
Situation<double> situation(std::uint64_t k)
{
    const auto random = [&](std::uint64_t which) { return hash_uniform(5, 32 * k + which); };
    Situation<double> s;
    s.point = {1.0 + random(0), 0.8 + 0.4 * random(1), 1.8 * random(2), random(3),
               0.5 + random(4), 2.0 + 5.0 * random(5), random(6) - 0.5, random(7) - 0.5};
    s.normal = normalized(test::random_vector(6, k));
    for (int c = 0; c < 3; ++c)
    {
        s.F.column[c] =
            Mat3::identity().column[c] + 0.25 * test::random_vector(7, 3 * k + static_cast<std::uint64_t>(c));
    }
    s.F = (k % 3 == 2 ? 0.8 : 1.3) * s.F;
    return s;
}

template <RealLike Real, class Convert>
Situation<Real> converted(const Situation<double>& s, Convert&& to)
{
    const auto vector = [&](const Vec3& v) { return BasicVec3<Real>{to(v.x), to(v.y), to(v.z)}; };
    const auto& p = s.point;
    return {{to(p.growth), to(p.radial_growth), to(p.growth_rate), to(p.radial_growth_rate), to(p.shear_modulus),
             to(p.bulk_modulus), to(p.shear_rate), to(p.bulk_rate)},
            vector(s.normal),
            {{vector(s.F.column[0]), vector(s.F.column[1]), vector(s.F.column[2])}}};
}

template <bool plain = false, class Law, RealLike Real>
material::BasicResponse<Real> response_of(const Law& law, const Situation<Real>& s)
{
    return material::respond<plain>(law, s.point, s.normal, s.F);
}

/// @param one  one(value) is the number in double   @param tolerance  of numbers of the size of the stress
template <class Other, class One>
void expect_same(const material::Response& exact, const Other& other, One&& one, double tolerance)
{
    const double size = tolerance * (1.0 + std::sqrt(contract(exact.P, exact.P)));
    EXPECT_NEAR(one(other.growth_volume), exact.growth_volume, size);
    EXPECT_NEAR(one(other.energy), exact.energy, size);
    EXPECT_NEAR(one(other.power), exact.power, size);
    EXPECT_NEAR(one(other.wave_speed), exact.wave_speed, size);
    EXPECT_NEAR(one(other.J_e), exact.J_e, size);
    for (int c = 0; c < 3; ++c)
    {
        EXPECT_NEAR(one(other.P.column[c].x), exact.P.column[c].x, size);
        EXPECT_NEAR(one(other.P.column[c].y), exact.P.column[c].y, size);
        EXPECT_NEAR(one(other.P.column[c].z), exact.P.column[c].z, size);
    }
}

constexpr std::uint64_t situations = 24;
constexpr double round_off = 1e-13; // some hundred operations on numbers of order one

template <class Law>
class AnyMaterial : public testing::Test
{
  protected:
    Law law{};
};
struct NeoHookeanWithBarrier : material::NeoHookean
{
    NeoHookeanWithBarrier() : material::NeoHookean{0.5} {}
};
struct MooneyRivlinWithBarrier : test::MooneyRivlin
{
    MooneyRivlinWithBarrier() : MooneyRivlin{0.4, 0.5} {}
};
using Materials = testing::Types<NeoHookeanWithBarrier, MooneyRivlinWithBarrier>;
TYPED_TEST_SUITE(AnyMaterial, Materials);

TYPED_TEST(AnyMaterial, SituationsReachTheBarrierAndStayOutOfIt)
{
    int below = 0;
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        ASSERT_GT(determinant(situation(k).F), 0.0) << k;
        below += response_of(this->law, situation(k)).J_e < 0.5 ? 1 : 0;
    }
    EXPECT_GT(below, 3);
    EXPECT_LT(below, 21);
}

TYPED_TEST(AnyMaterial, FloatGivesTheNumbersOfDouble)
{
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        SCOPED_TRACE(k);
        const auto s = converted<float>(situation(k), [](double value) { return static_cast<float>(value); });
        expect_same(
            response_of(this->law, situation(k)), response_of(this->law, s),
            [](float value) { return static_cast<double>(value); }, 1e-5);
    }
}

TYPED_TEST(AnyMaterial, EightLanesGiveTheNumbersOfOneEach)
{
    for (std::uint64_t first = 0; first < situations; first += wide_lanes)
    {
        Situation<WideLanes> wide{};
        for (int lane = 0; lane < wide_lanes; ++lane)
        {
            // Adds the situation in this lane to those in the lanes before it.
            const auto s = converted<WideLanes>(situation(first + static_cast<std::uint64_t>(lane)),
                                                [&](double value)
                                                {
                                                    WideLanes in_lane{};
                                                    in_lane[lane] = value;
                                                    return in_lane;
                                                });
            wide.point.growth += s.point.growth;
            wide.point.radial_growth += s.point.radial_growth;
            wide.point.growth_rate += s.point.growth_rate;
            wide.point.radial_growth_rate += s.point.radial_growth_rate;
            wide.point.shear_modulus += s.point.shear_modulus;
            wide.point.bulk_modulus += s.point.bulk_modulus;
            wide.point.shear_rate += s.point.shear_rate;
            wide.point.bulk_rate += s.point.bulk_rate;
            wide.normal += s.normal;
            wide.F += s.F;
        }
        const auto answers = response_of(this->law, wide);
        for (int lane = 0; lane < wide_lanes; ++lane)
        {
            expect_same(
                response_of(this->law, situation(first + static_cast<std::uint64_t>(lane))), answers,
                [&](const WideLanes& value) { return value[lane]; }, round_off);
        }
    }
}

TYPED_TEST(AnyMaterial, StressIsTheDerivativeOfTheEnergy)
{
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        const material::Response exact = response_of(this->law, situation(k));
        const double size = round_off * (1.0 + std::sqrt(contract(exact.P, exact.P)));
        for (int entry = 0; entry < 9; ++entry)
        {
            auto s = converted<Dual>(situation(k), [](double value) { return Dual{value}; });
            s.F(entry / 3, entry % 3).slope = 1.0;
            const auto derived = response_of(this->law, s);
            EXPECT_NEAR((derived.growth_volume * derived.energy).slope, exact.P(entry / 3, entry % 3), size) << k;
        }
    }
}

TYPED_TEST(AnyMaterial, PowerIsTheRateOfTheEnergyAsThePointGrows)
{
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        auto s = converted<Dual>(situation(k), [](double value) { return Dual{value}; });
        s.point.growth.slope = s.point.growth_rate.value;
        s.point.radial_growth.slope = s.point.radial_growth_rate.value;
        s.point.shear_modulus.slope = s.point.shear_rate.value;
        s.point.bulk_modulus.slope = s.point.bulk_rate.value;
        const auto derived = response_of(this->law, s);
        const double rate = (derived.growth_volume * derived.energy).slope;
        EXPECT_NEAR(derived.growth_volume.value * derived.power.value, rate, round_off * (10.0 + std::abs(rate))) << k;
    }
}

TYPED_TEST(AnyMaterial, PlainGrowthIsGrowthInThePlaneAlone)
{
    for (std::uint64_t k = 0; k < situations; ++k)
    {
        Situation<double> s = situation(k);
        s.point.radial_growth = 1.0;
        s.point.radial_growth_rate = 0.0;
        s.point.shear_rate = 0.0;
        s.point.bulk_rate = 0.0;
        expect_same(
            response_of(this->law, s), response_of<true>(this->law, s), [](double value) { return value; }, round_off);
    }
}

TYPED_TEST(AnyMaterial, ModuliAreThoseAtRest)
{
    constexpr double mu = 0.86;
    constexpr double K = 4.3;
    // Derivatives of the stress at rest: that of uniaxial strain is K + 4/3 mu, that of shear is mu.
    auto F = converted<Dual>(Situation<double>{{}, {}, Mat3::identity()}, [](double value) { return Dual{value}; }).F;
    F(0, 0).slope = 1.0;
    const Dual moduli[] = {mu, K};
    EXPECT_NEAR(material::elastic_response(this->law, moduli[0], moduli[1], F).stress(0, 0).slope,
                material::longitudinal_modulus(material::MaterialPoint{1.0, 1.0, 0.0, 0.0, mu, K}), round_off);
    F(0, 0).slope = 0.0;
    F(0, 1).slope = 1.0;
    EXPECT_NEAR(material::elastic_response(this->law, moduli[0], moduli[1], F).stress(0, 1).slope, mu, round_off);
}

} // namespace
} // namespace corticle
