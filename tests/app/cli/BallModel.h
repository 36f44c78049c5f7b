// Writes a textured ball as an OBJ file, the model of the command-line tests.
#pragma once

#include <QString>

namespace dipwright::test {

// Writes FOLDER/ball.obj, a ball of 40 mm with longitude and latitude as texture coordinates, with
// ball.mtl and ball.png beside it. Returns the OBJ's path.
QString writeBall(const QString& folder);

} // namespace dipwright::test
