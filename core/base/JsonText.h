// Checks the size of JSON from untrusted sources before it is parsed.
#pragma once

#include <QByteArray>
#include <QString>

namespace dipwright {

// Throws Error about `where` if the text holds more values, or nests them deeper, than Budgets.h
// allows. The limits protect memory: two bytes of JSON can take a hundred bytes once parsed.
// Written again with four spaces for each level, they can take thousands. Does not check that the
// text is valid JSON.
void requireJsonWithinLimits(const QByteArray& text, const QString& where);

// Returns the path, such as "film.points", of the first key that an object holds twice; empty if
// there is none. The text must be valid JSON. Compares keys as they are written.
QString repeatedKey(const QByteArray& text);

} // namespace dipwright
