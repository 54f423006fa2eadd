// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace dealii {}

/** The project. Names of deal.II are known inside; a name of this project hides one of deal.II. */
namespace Signorini {
using namespace dealii;
}
