// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/discretization/space/foreign_field.h>
#include <signorini/error_control/reference/field_works.h>

namespace Signorini {
/**
 * Returns the works of the displacement of another program.
 *
 * Cells and edges are cut where data is not smooth, and halved until they are as small as the boxes
 * that show the data and two rules agree to 1e-13 of |||v|||², or there are too many parts. The
 * differences that are left and the load between points of rules make up the margin; it is infinite
 * where parts are still too large.
 */
FieldWorks works_of(const ForeignField &field, const Scene<2> &scene);
} // namespace Signorini
