// JSON from elsewhere, before it is parsed.
#pragma once

#include <QByteArray>
#include <QString>

namespace dipwright {

// Throws Error about `where` where the text holds more values, or nests them deeper, than Budgets.h
// allows. Two bytes of it can take a hundred in memory, and when they are written again, with four
// spaces for each level, thousands. Whether it is JSON at all is not looked at.
void requireModestJson(const QByteArray& text, const QString& where);

} // namespace dipwright
