// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../catch.hpp"
#include "examples.hpp"

#include <pendular/testing/archetypes.hpp>
#include <pendular/testing/law_kits.hpp>

#include <boost/hana/for_each.hpp>

#include <string>
#include <typeinfo>

// Every shipped law and every archetype keeps the promises of its concept; in several sources, since each law is
// compiled in five scalars.
namespace kits {
using namespace pendular;

template <class List, class Report>
void require_sound(List laws, const Report& report_of) {
  boost::hana::for_each(laws, [&]<class L>(L) {
    for (const std::string& broken : report_of(examples::of<typename L::type>::value)) {
      FAIL_CHECK(typeid(typename L::type).name() << ": " << broken);
    }
    SUCCEED();
  });
}

}  // namespace kits
