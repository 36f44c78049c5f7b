// Writes a textured ball as an OBJ file. The tests of the command line use it as their model.
#pragma once

#include <QString>

namespace dipwright::test {

// Writes FOLDER/ball.obj, with ball.mtl and ball.png: a ball of 40 mm diameter whose texture
// coordinates are longitude and latitude. Returns the path of ball.obj.
QString writeBall(const QString& folder);

} // namespace dipwright::test
