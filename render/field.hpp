#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/measurement/frame.hpp"
#include "render/colour_map.hpp"
#include "render/range.hpp"

namespace asperity::render {

/// What a picture can show.
enum class Field { cracks, contacts, damage, stress, compressive_stress, shear_stress, fragments, displacement };

/// All fields, in the order of the enumeration.
const std::vector<Field>& all_fields();

/// The name on the command line and in file names, as in the enumeration.
std::string_view field_name(Field field);

/// The field of that name, if there is one.
std::optional<Field> field_from_name(std::string_view name);

/// How a field with a colour bar is coloured. `label` names quantity and unit.
struct FieldColours {
  ColourMap map = ColourMap::viridis;
  std::string label;
};

/// Nothing for cracks, contacts and fragments, which have a legend instead.
std::optional<FieldColours> field_colours(Field field);

/// One value per triangle: MPa (compressive stress: compression positive), mm, or damage; empty for fields with a
/// legend.
std::vector<double> field_values(const Frame& frame, Field field);

/// The colour range of values of one frame: 0 to 1 for damage, symmetric about 0 for stress, else from 0; robust
/// percentiles, so that single contacts about to break do not pale all others.
Range field_range(Field field, const std::vector<double>& values);

/// The range of what the field shows of a frame: of colours, or for contacts of the normal forces (N) that line widths
/// stand for; nothing for cracks and fragments.
std::optional<Range> frame_range(const Frame& frame, Field field);

/// The range for one frame of a run: `run`, which holds for all frames; but for contacts the frame's own, since chains
/// of forces show what the load does within a frame, unless the frame's forces are below 2 % of the run's.
std::optional<Range> range_in_run(const Frame& frame, Field field, const std::optional<Range>& run);

}  // namespace asperity::render
