// SPDX-License-Identifier: BSD-3-Clause
// Tables before scenes and checkpoints: io::column, of a table, must not hide the columns of grains.
#include <pendular/io/table.hpp>
// after it, whatever the alphabet says
#include <pendular/scene/packing.hpp>
