#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Starts a test in a folder of its own, which is empty.
# usage: start.sh FOLDER COMMAND...
set -eu
folder=$1
shift
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
exec "$@"
