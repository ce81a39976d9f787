// weft: cloth and other deformable surfaces as mass-spring systems on GPU and CPU.
#pragma once

#include "weft/context.hpp"
#include "weft/core.hpp"
#include "weft/debug_draw.hpp"
#include "weft/fabric.hpp"
#include "weft/world.hpp"
