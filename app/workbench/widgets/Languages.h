// The languages that the program speaks.
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

// Before any window is made. An empty code: the system's language, else English.
void installLanguage(QCoreApplication& application, const QString& code);

} // namespace dipwright
