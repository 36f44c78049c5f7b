// Makes CAD files with OpenCASCADE for tests.
#pragma once

#include <QString>

namespace dipwright::test {

// Writes a bracket as STEP or IGES, by the path's suffix: a plate of 40 × 5 × 30 mm in the plane
// y = 0 and an upright of 25 mm with a hole of 12 mm. The plate's underside is the face "Logo", in
// red (204, 26, 26); the rest is blue (51, 102, 153). `unit` is the file's unit: "MM", "INCH" or
// "M".
void writeBracket(const QString& path, const char* unit = "MM");

// Writes an assembly as STEP. Each level contains the level below twice, so that it has 2^levels
// boxes.
void writeDoubled(const QString& path, int levels);

// Writes unnamed boxes as STEP, all in one part.
void writeBoxes(const QString& path, int boxes);

} // namespace dipwright::test
