// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/problem/parameters/parameters.h>
#include <signorini/problem/scene/scene.h>

#include <vector>

namespace Signorini
{
/** Reads the subsection Load cases. @throws InputError. */
std::vector<LoadCase> read_load_cases(const LoadCasesParameters &given, const Scene<2> &scene);
} // namespace Signorini
