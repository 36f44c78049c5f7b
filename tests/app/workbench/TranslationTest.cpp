// Checks that the translations are complete, keep their placeholders and match the current texts.
#include "TestFolders.h"
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

namespace {

const QString sources = sourceFolder();

struct Message {
    QString context, source;
    QStringList translations; // one per plural form
    bool finished = true;
};

QList<Message> readMessages(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QList<Message> messages;
    QString context;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("message")) {
            messages.append({.context = context, .source = {}, .translations = {}});
        } else if (xml.name() == QLatin1String("source")) {
            messages.last().source = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            messages.last().finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
            const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
            messages.last().translations.append(text);
        }
    }
    return messages;
}

// Returns all translated texts, each with its context in front.
const QSet<QString>& listed() {
    static const QSet<QString> found = [] {
        QSet<QString> all;
        for (const Message& message :
             readMessages(sources + QStringLiteral("/translations/dipwright_de.ts"))) {
            all.insert(message.context + message.source);
        }
        return all;
    }();
    return found;
}

QString textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList filesIn(const QString& folder, const QStringList& patterns) {
    QStringList files;
    QDirIterator every(folder, patterns, QDir::Files, QDirIterator::Subdirectories);
    while (every.hasNext()) {
        files += every.next();
    }
    return files;
}

// Returns the text of adjacent C++ string literals.
QString joined(const QString& literals) {
    static const QRegularExpression literal(QStringLiteral("\"((?:[^\"\\\\]|\\\\.)*)\""));
    QString text;
    for (const auto& match : literal.globalMatch(literals)) {
        text += match.captured(1);
    }
    return text.replace(QStringLiteral("\\n"), QStringLiteral("\n"))
        .replace(QStringLiteral("\\\""), QStringLiteral("\""));
}

QSet<QString> places(const QString& text) {
    static const QRegularExpression place(QStringLiteral("%(L?\\d+|n)"));
    QSet<QString> found;
    for (const auto& match : place.globalMatch(text)) {
        found.insert(match.captured());
    }
    return found;
}

} // namespace

class TranslationTest : public QObject {
    Q_OBJECT

private slots:
    void translations_everyText_isTranslated_data() { addLanguages(); }
    void translations_everyText_isTranslated() {
        QFETCH(QString, file);
        const QList<Message> messages = readMessages(file);
        QVERIFY(messages.size() > 500);
        for (const Message& message : messages) {
            QVERIFY2(message.finished && !message.translations.value(0).isEmpty(),
                     qPrintable(message.context + QStringLiteral(": ") + message.source));
        }
    }

    void translations_placeholders_areKept_data() { addLanguages(); }
    void translations_placeholders_areKept() {
        QFETCH(QString, file);
        for (const Message& message : readMessages(file)) {
            for (const QString& translation : message.translations) {
                QVERIFY2(places(translation) == places(message.source), qPrintable(message.source));
            }
        }
    }

    // In German, a diver makes a Tauchgang, and a part has a Tauchvorgang.
    void translations_germanForDip_isTauchvorgang() {
        for (const char* file : {"/translations/dipwright_de.ts", "/resources/guide/guide.de.md"}) {
            const QString text = textOf(sources + QLatin1String(file));
            QVERIFY(text.contains(QStringLiteral("Tauchvorgang")));
            QVERIFY2(!text.contains(QStringLiteral("tauchgang"), Qt::CaseInsensitive) &&
                         !text.contains(QStringLiteral("tauchgäng"), Qt::CaseInsensitive),
                     file);
        }
    }
    void guide_everyLanguage_hasSameChapters() {
        const int chapters = chaptersOf(QStringLiteral("guide.md"));
        QVERIFY(chapters > 5);
        QCOMPARE(chaptersOf(QStringLiteral("guide.de.md")), chapters);
        QCOMPARE(chaptersOf(QStringLiteral("guide.pt_BR.md")), chapters);
    }

    // lupdate reads the sources again, so that a changed text fails until it is translated again.
    // If lupdate cannot tell a text's context, it lists the text in a context that the program
    // never uses.
    void translations_textsFoundByLupdate_areListed() {
        const QTemporaryDir folder;
        const QString fresh = folder.filePath(QStringLiteral("fresh.ts"));
        QProcess lupdate;
        lupdate.start(QStringLiteral(DIPWRIGHT_LUPDATE),
                      {QStringLiteral("-silent"), QStringLiteral("-extensions"),
                       QStringLiteral("cpp,h"), sources + QStringLiteral("/app"),
                       sources + QStringLiteral("/core"), QStringLiteral("-ts"), fresh});
        QVERIFY(lupdate.waitForFinished(60'000));
        QCOMPARE(QString::fromLocal8Bit(lupdate.readAllStandardError()), QString());
        const QList<Message> current = readMessages(fresh);
        QVERIFY(current.size() > 500);
        for (const Message& message : current) {
            QVERIFY2(listed().contains(message.context + message.source),
                     qPrintable(message.context + QStringLiteral(": ") + message.source));
        }
    }

    // Reads the texts without lupdate, from all files that declare their context.
    void translations_textsOfDeclaredContext_areListed() {
        static const QRegularExpression contextOf(
            QStringLiteral(R"(Q_DECLARE_TR_FUNCTIONS\(([\w:]+)\))"));
        static const QRegularExpression asked(
            QStringLiteral("Text::tr\\(\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)"));
        int files = 0, texts = 0;
        for (const QString& folder : {QStringLiteral("/app"), QStringLiteral("/core")}) {
            for (const QString& path : filesIn(sources + folder, {QStringLiteral("*.cpp")})) {
                const QString code = textOf(path);
                const QString context = contextOf.match(code).captured(1);
                files += context.isEmpty() ? 0 : 1;
                for (const auto& match : asked.globalMatch(code)) {
                    const QString text = joined(match.captured(1));
                    QVERIFY2(listed().contains(context + text),
                             qPrintable(path + QStringLiteral(": ") + text));
                    ++texts;
                }
            }
        }
        QVERIFY(files > 30 && texts > 200);
    }

    void translations_shippedNames_areListed() {
        const QStringList patterns{QStringLiteral("*.json"), QStringLiteral("*.json.in")};
        const QStringList files =
            filesIn(sources + QStringLiteral("/resources/profiles"), patterns) +
            filesIn(sources + QStringLiteral("/plugins"), patterns);
        QVERIFY(files.size() > 8);
        static const QRegularExpression nameLine(QStringLiteral("\"name\": \"([^\"]+)\""));
        for (const QString& path : files) {
            const QString name = nameLine.match(textOf(path)).captured(1);
            QVERIFY2(listed().contains(QStringLiteral("ShippedNames") + name), qPrintable(path));
        }
    }

private:
    static int chaptersOf(const QString& guide) {
        const QString path = sources + QStringLiteral("/resources/guide/") + guide;
        return int(textOf(path).count(QStringLiteral("\n## ")));
    }
    void addLanguages() {
        QTest::addColumn<QString>("file");
        const QDir folder(sources + QStringLiteral("/translations"));
        for (const QString& name : folder.entryList({QStringLiteral("*.ts")})) {
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
        }
    }
};

QTEST_GUILESS_MAIN(TranslationTest)
#include "TranslationTest.moc"
