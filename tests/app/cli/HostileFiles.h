// Files as an attacker makes them, one of each kind that has once done harm or was made to.
#pragma once

#include <QString>

namespace dipwright::test {

void writeHostileFiles(const QString& folder);

} // namespace dipwright::test
