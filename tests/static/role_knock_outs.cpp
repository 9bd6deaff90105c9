// SPDX-License-Identifier: BSD-3-Clause
// As knock_outs.cpp, for roles that are no laws: each has one mistake and is refused, the whole it was made of is not.
#include "none_of.hpp"

#include <pendular/motion/check.hpp>
#include <pendular/testing/role_knock_outs.hpp>

using namespace pendular;
namespace knock_out = pendular::testing::knock_out;

namespace {

static_assert(Integrator<knock_out::integrator::whole>);
static_assert(none_of(knock_out::integrators, []<class M>(M) { return Integrator<type_of<M>>; }));
static_assert(boundary::Geometry<boundary::plane>);
static_assert(none_of(knock_out::geometries, []<class M>(M) { return boundary::Geometry<type_of<M>>; }));
static_assert(boundary::Drive<knock_out::drive::whole, boundary::plane> &&
              boundary::Drive<knock_out::drive::of_points, boundary::plane>);
static_assert(none_of(knock_out::drives, []<class M>(M) { return boundary::Drive<type_of<M>, boundary::plane>; }));
static_assert(boundary::Wall<knock_out::wall::whole>);
static_assert(none_of(knock_out::walls, []<class M>(M) { return boundary::Wall<type_of<M>>; }));
static_assert(boundary::Boundary<knock_out::boundary_of::whole>);
static_assert(none_of(knock_out::boundaries, []<class M>(M) { return boundary::Boundary<type_of<M>>; }));
static_assert(FormationRule<formation::at_contact>);
static_assert(none_of(knock_out::formation_rules, []<class M>(M) { return FormationRule<type_of<M>>; }));
static_assert(LocalProtocol<knock_out::local_protocol::whole>);
static_assert(none_of(knock_out::local_protocols, []<class M>(M) { return LocalProtocol<type_of<M>>; }));
static_assert(GlobalProtocol<knock_out::global_protocol::whole>);
static_assert(none_of(knock_out::global_protocols, []<class M>(M) { return GlobalProtocol<type_of<M>>; }));
static_assert(Source<knock_out::source::whole>);
static_assert(none_of(knock_out::sources, []<class M>(M) { return Source<type_of<M>>; }));
static_assert(GrainTag<knock_out::grain_tag::whole>);
static_assert(none_of(knock_out::grain_tags, []<class M>(M) { return GrainTag<type_of<M>>; }));

// Of a system called int.
struct changes_the_scene {
  void operator()(int&) {}
};
struct hears_of_steps {
  void notice(std::int64_t) {}
};
struct looks_at_steps {
  void operator()(const int&) {}
};
static_assert(Observer<looks_at_steps, int> && Observer<null_observer, int>);
static_assert(!Observer<changes_the_scene, int> && !Observer<hears_of_steps, int> && !Observer<double, int>);

}  // namespace
