// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/dealii.h>
#include <signorini/problem/scene/scene.h>

namespace Signorini {
/**
 * Finds where the formulas of a scene are not smooth: the lines on which they change by switches,
 * and the breaks on sides and the boxes in the body between which Gauss' rules show them.
 *
 * Formulas are enclosed in boxes, so that nothing hides between points. A box in which one of them
 * is not shown (FormulaTree::is_shown()) is halved; boxes in the body down to 1/4096 of its extent
 * (6e-8 where they hold much of the load), intervals on a side until a jump is known up to 1e-10
 * of its length. Data that varies by less than 1e-9 of the mean of its absolute value, times the
 * body's area over that of the box, counts as constant. Formulas of the catalogue and distances to
 * foundations are not scanned; their kinks are declared.
 *
 * A line of a switch is left out only where bounds show, along all of it, that the branches on its
 * two sides are smooth, and these agree at points of each part. The lines are added to those of the
 * scene, and all kinks lose their ends.
 */
void scan_data(Scene<2> &scene);
} // namespace Signorini
