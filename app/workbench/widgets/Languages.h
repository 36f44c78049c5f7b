// The languages of the program.
#pragma once

#include <QString>
#include <vector>

class QCoreApplication;

namespace dipwright {

struct Language {
    QString code; // "en", "de", "pt_BR"
    QString name; // in the language itself
};
std::vector<Language> languages();

// Call this before any window is created. An empty code: the system's language, else English.
void installLanguage(QCoreApplication& application, const QString& code);

} // namespace dipwright
