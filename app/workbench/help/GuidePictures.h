// The guide's pictures of the five minutes at the tank, drawn by the program in the user's
// language.
#pragma once

#include <QImage>
#include <QStringList>

namespace dipwright {

// As the guide names their files: "tank-pages", "tank-water", "tank-photos".
QStringList guidePictures();
// One of them, `width` pixels wide.
QImage guidePicture(const QString& name, int width);

} // namespace dipwright
