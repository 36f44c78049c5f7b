// The schema of project.json, version 2 (docs/files-and-commands.md, "The project file"), as tables
// of fields. Private to this folder but for the limits, which the dialogs show.
#pragma once

#include "project/Field.h"
#include "project/Project.h"

#include <vector>

namespace dipwright {

inline constexpr int projectVersion = 2;

// In the order in which a file is read: a film's preset comes before its size, its size before its
// points, its points and its cell before which of them counts, as each sets what follows.
const std::vector<Field<Project>>& projectFields();
const std::vector<Field<Immersion>>& immersionFields();
const std::vector<Field<ShareMark>>& shareMarkFields();
const std::vector<Field<ZoneMark>>& zoneMarkFields();
const std::vector<Field<BuiltPart>>& builtPartFields();
const std::vector<Field<BuiltPlace>>& builtPlaceFields();
const std::vector<Field<InspectedPhoto>>& inspectedPhotoFields();
const std::vector<Field<ClickedPair>>& clickedPairFields();
const std::vector<Field<FloatingPhoto>>& floatingPhotoFields();
// Of "artwork" beside its layers, and of a layer. A layer's picture is told by its id.
const std::vector<Field<Artwork>>& artworkFields();
const std::vector<Field<ArtworkLayer>>& artworkLayerFields();

} // namespace dipwright
