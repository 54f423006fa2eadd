// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// NOLINTBEGIN(bugprone-macro-parentheses): the name of a template cannot stand in parentheses.
/** Instantiates a template of functions, whose only parameter is the dimension, in 2-D and 3-D. */
#define INSTANTIATE_FUNCTION(name)                                                                 \
  template decltype(name<2>) name<2>;                                                              \
  template decltype(name<3>) name<3>
// NOLINTEND(bugprone-macro-parentheses)
