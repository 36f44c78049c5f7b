// Size checks for JSON from elsewhere, before it is parsed.
#pragma once

#include <QByteArray>
#include <QString>

namespace dipwright {

// Throws Error about `where` if the text holds more values, or nests them deeper, than Budgets.h
// allows. Two bytes of JSON can take a hundred bytes of memory once parsed, and thousands when
// written again with four spaces for each level. Does not check that the text is valid JSON.
void requireJsonWithinLimits(const QByteArray& text, const QString& where);

} // namespace dipwright
