// Defines project.json, version 3 (docs/files-and-commands.md, "The project file"), as tables of
// fields. Private to this folder, except that the dialogs show the limits.
#pragma once

#include "project/Field.h"
#include "project/Project.h"

#include <vector>

namespace dipwright {

inline constexpr int projectVersion = 3;

// Returns the fields in the order of reading. Setting a field can change later ones. So a film's
// preset comes before its size, the size before points and cell, and these before the choice
// between them.
const std::vector<Field<Project>>& projectFields();
const std::vector<Field<Immersion>>& immersionFields();
const std::vector<Field<ShareMark>>& shareMarkFields();
const std::vector<Field<ZoneMark>>& zoneMarkFields();
const std::vector<Field<MaskMark>>& maskMarkFields();
const std::vector<Field<BuiltPart>>& builtPartFields();
const std::vector<Field<TankTime>>& tankTimeFields();
const std::vector<Field<BuiltPlace>>& builtPlaceFields();
const std::vector<Field<InspectedPhoto>>& inspectedPhotoFields();
const std::vector<Field<ClickedPair>>& clickedPairFields();
const std::vector<Field<FloatingPhoto>>& floatingPhotoFields();
// Returns the fields of "artwork" without its layers.
const std::vector<Field<Artwork>>& artworkFields();
// Returns the fields of a layer. A layer names its picture by an id.
const std::vector<Field<ArtworkLayer>>& artworkLayerFields();

} // namespace dipwright
