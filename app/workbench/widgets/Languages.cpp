#include "workbench/widgets/Languages.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace dipwright {

std::vector<Language> languages() {
    return {{QStringLiteral("en"), QStringLiteral("English")},
            {QStringLiteral("de"), QStringLiteral("Deutsch")},
            {QStringLiteral("pt_BR"), QStringLiteral("Português (Brasil)")}};
}

void installLanguage(QCoreApplication& application, const QString& code) {
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    if (!code.isEmpty()) {
        QLocale::setDefault(locale);
    }
    // Qt's own texts (buttons, file dialogs) come first, so that our translations take precedence.
    auto* qt = new QTranslator(&application);
    if (qt->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                 QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(qt);
    }
    auto* own = new QTranslator(&application);
    if (own->load(locale, QStringLiteral("dipwright"), QStringLiteral("_"),
                  QStringLiteral(":/translations"))) {
        QCoreApplication::installTranslator(own);
    }
}

} // namespace dipwright
