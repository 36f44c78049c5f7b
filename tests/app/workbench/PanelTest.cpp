// Tests the panels without a window: fields, heat scale, isolines, timeline and picture view.
#include "BoxProject.h"
#include "Contrast.h"
#include "geometry/Shapes.h"
#include "project/Schema.h"
#include "workbench/accuracy/VerdictPanel.h"
#include "workbench/accuracy/ZoneFields.h"
#include "workbench/document/ProjectValue.h"
#include "workbench/project/FilmFacts.h"
#include "workbench/project/PropertyField.h"
#include "workbench/project/PropertyPanel.h"
#include "workbench/project/PropertySpecs.h"
#include "workbench/results/ResultsPanel.h"
#include "workbench/results/Timeline.h"
#include "workbench/widgets/HeatScale.h"
#include "workbench/widgets/Languages.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"
#include "workbench/widgets/PictureView.h"
#include "workbench/widgets/PlainTexts.h"
#include "workbench/widgets/Theme.h"
#include "workbench/widgets/WheelGuard.h"

#include <QApplication>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QJsonArray>
#include <QLineEdit>
#include <QScreen>
#include <QScrollBar>
#include <QSet>
#include <QSignalSpy>
#include <QSlider>
#include <QTabBar>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>
#include <QToolTip>
#include <QTranslator>
#include <QWheelEvent>

using namespace dipwright;

namespace {

std::vector<PropertySpec> allSpecs() {
    std::vector<PropertySpec> all;
    for (const ProjectPart part : {ProjectPart::Project, ProjectPart::Model, ProjectPart::Film,
                                   ProjectPart::Process, ProjectPart::Immersion, ProjectPart::Share,
                                   ProjectPart::Sheet, ProjectPart::Ink, ProjectPart::Tolerance}) {
        for (const PropertySection& section : propertySections({part, 0})) {
            all.insert(all.end(), section.specs.begin(), section.specs.end());
        }
    }
    return all;
}

PropertySpec specOf(const QString& path) {
    for (const PropertySpec& spec : allSpecs()) {
        if (spec.path == path) {
            return spec;
        }
    }
    return {};
}

// The program's texts are in this language until the end of its life.
class LanguageInUse {
public:
    explicit LanguageInUse(const QString& code) { installLanguage(*qApp, code); }
    ~LanguageInUse() {
        QLocale::setDefault(QLocale::c());
        qDeleteAll(qApp->findChildren<QTranslator*>());
    }
};

} // namespace

class PanelTest : public QObject {
    Q_OBJECT

private slots:
    void propertySections_everyProjectValue_hasField() {
        QSet<QString> shown;
        for (const PropertySpec& spec : allSpecs()) {
            QVERIFY2(!spec.label.isEmpty() && !spec.help.isEmpty(), qPrintable(spec.path));
            valueRule(spec.path); // throws for an unknown path
            shown.insert(spec.path);
        }
        const QSet<QString> elsewhere{
            QStringLiteral("model.source"),           QStringLiteral("model.texture_source"),
            QStringLiteral("model.unit_mm"),          QStringLiteral("model.sha256"),
            QStringLiteral("model.remarks"),         // shown with the model's facts
            QStringLiteral("model.losses"),          // likewise
            QStringLiteral("model.tessellation_mm"), // these three are shown for a CAD model
            QStringLiteral("model.file_unit"),        QStringLiteral("model.cad_file"),
            QStringLiteral("process.solver"),        // in its own list
            QStringLiteral("inspection.chessboard"), // on its own page
            QStringLiteral("inspection.keep_camera"),
        };
        for (const auto& field : projectFields()) {
            QVERIFY2(shown.contains(field.path) || elsewhere.contains(field.path) ||
                         field.path.startsWith(QLatin1String("pose_search.")) || // on its own page
                         field.path.startsWith(QLatin1String("inspection.film.")), // the same
                     qPrintable(field.path));
        }
    }

    void propertyField_typedInches_emitsMillimetres() {
        const PropertySpec spec = specOf(QStringLiteral("film.size_mm"));
        const std::unique_ptr<PropertyField> field(
            PropertyField::make(spec, valueRule(spec.path), LengthUnit::Inch, nullptr));
        QSignalSpy edited(field.get(), &PropertyField::edited);
        field->show(QJsonArray{254.0, 297.0});
        QCOMPARE(edited.count(), 0);
        auto* width = field->findChildren<QDoubleSpinBox*>().at(0);
        QCOMPARE(width->value(), 10.0); // inches
        QCOMPARE(width->suffix(), QStringLiteral(" in"));
        width->setValue(11);
        QCOMPARE(edited.count(), 1);
        const QJsonArray size = edited[0][0].toJsonValue().toArray();
        QCOMPARE(size.at(0).toDouble(), 279.4);
        QCOMPARE(size.at(1).toDouble(), 297.0); // not rounded by the display in inches
    }

    void propertyField_colour_opensColourDialog() {
        const PropertySpec spec = specOf(QStringLiteral("body.base_colour"));
        const std::unique_ptr<PropertyField> field(
            PropertyField::make(spec, valueRule(spec.path), LengthUnit::Millimetre, nullptr));
        QSignalSpy edited(field.get(), &PropertyField::edited);
        field->show(QStringLiteral("#102030"));
        auto* button = field->findChild<QToolButton*>();
        QVERIFY(button && !button->icon().isNull() && !button->accessibleName().isEmpty());
        button->click();
        auto* dialog = field->findChild<QColorDialog*>();
        QVERIFY(dialog);
        QCOMPARE(dialog->currentColor(), QColor(0x10, 0x20, 0x30));
        dialog->setCurrentColor(QColor(0xaa, 0xbb, 0xcc));
        dialog->accept();
        QCOMPARE(edited.count(), 1);
        QCOMPARE(edited[0][0].toJsonValue(), QJsonValue(QStringLiteral("#aabbcc")));
        QVERIFY(!PropertyField::make(specOf(QStringLiteral("sheet.white_name")),
                                     valueRule(QStringLiteral("sheet.white_name")),
                                     LengthUnit::Millimetre, field.get())
                     ->findChild<QToolButton*>());
    }

    void propertyField_linkedPair_setsBothNumbers() {
        const PropertySpec spec = specOf(QStringLiteral("film.swell"));
        const std::unique_ptr<PropertyField> field(
            PropertyField::make(spec, valueRule(spec.path), LengthUnit::Millimetre, nullptr));
        QSignalSpy edited(field.get(), &PropertyField::edited);
        const auto boxes = field->findChildren<QDoubleSpinBox*>();
        auto* link = field->findChild<QToolButton*>();
        QVERIFY(link && link->isChecked());
        field->show(QJsonArray{1, 1});
        boxes[1]->setValue(1.06);
        QCOMPARE(edited.takeFirst()[0].toJsonValue(), QJsonValue(QJsonArray{1.06, 1.06}));
        field->show(QJsonArray{1.06, 1.06});
        link->click();
        boxes[0]->setValue(1.03);
        QCOMPARE(edited.takeFirst()[0].toJsonValue(), QJsonValue(QJsonArray{1.03, 1.06}));
        field->show(QJsonArray{1.03, 1.06});
        link->click(); // the first number holds for both
        QCOMPARE(edited.takeFirst()[0].toJsonValue(), QJsonValue(QJsonArray{1.03, 1.03}));
        field->show(QJsonArray{1.1, 1.2}); // as if measured
        QVERIFY(!link->isChecked());
    }

    void numberBox_commaOrPoint_isDecimalSign_data() {
        QTest::addColumn<QLocale>("locale");
        QTest::addColumn<QString>("typed");
        for (const QLocale::Language language :
             {QLocale::English, QLocale::German, QLocale::Portuguese}) {
            for (const char* typed : {"1,06", "1.06"}) {
                const QLocale locale(language);
                QTest::addRow("%s %s", qPrintable(locale.name()), typed)
                    << locale << QString::fromLatin1(typed);
            }
        }
    }
    void numberBox_commaOrPoint_isDecimalSign() {
        QFETCH(QLocale, locale);
        QFETCH(QString, typed);
        NumberBox box;
        box.setLocale(locale);
        box.setDecimals(3);
        box.setRange(0, 5000);
        box.setSuffix(QStringLiteral(" mm"));
        box.selectAll();
        QTest::keyClicks(&box, typed);
        QCOMPARE(box.value(), 1.06);
    }

    void numberBox_typedUnit_isConverted_data() {
        QTest::addColumn<QLocale>("locale");
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("value");
        const QLocale english(QLocale::English), german(QLocale::German);
        const auto row = [](const QLocale& locale, const char* suffix, const char* typed,
                            double value) {
            QTest::addRow("%s in%s, %s", typed, suffix, qPrintable(locale.name()))
                << locale << QString::fromUtf8(suffix) << QString::fromUtf8(typed) << value;
        };
        row(english, " mm", "2in", 50.8);
        row(english, " mm", "2\"", 50.8);
        row(english, " mm", "1.5 cm", 15);
        row(english, " mm", "0.2 m", 200);
        row(english, " mm", "1'", 304.8);
        row(german, " mm", "2 zoll", 50.8);
        row(german, " mm", "1,5 cm", 15);
        row(english, " in", "1 mm", 1 / 25.4);
        row(english, " mm/s", "6 cm/min", 1);
        row(english, " s", "2 min", 120);
        row(english, " mm", "3*12", 36);
        row(german, " mm", "2,5*2", 5);
        row(english, "°", "0.5turn", 180);
        row(english, " mm", "1,234.5", 1234.5);
        row(german, " mm", "1.234,5", 1234.5);
        row(english, " mm", "1.234,5", 1234.5);
        row(german, " mm", "1 234,5", 1234.5);
        row(english, " mm", "1.2345", 1.2345); // keeps all digits
        row(english, " mm", "0,125", 0.125);
        row(english, " ×", "4,321", 4.321); // 4321 is beyond the limits
    }
    void numberBox_typedUnit_isConverted() {
        QFETCH(QLocale, locale);
        QFETCH(QString, suffix);
        QFETCH(QString, typed);
        QFETCH(double, value);
        NumberBox box;
        box.setLocale(locale);
        box.setRange(0, suffix == QStringLiteral(" ×") ? 10 : 5000);
        box.setSuffix(suffix);
        box.setKeyboardTracking(false);
        const QSignalSpy refused(&box, &NumberBox::refused);
        box.selectAll();
        QTest::keyClicks(&box, typed);
        QTest::keyClick(&box, Qt::Key_Return);
        QVERIFY(refused.isEmpty());
        QVERIFY2(std::abs(box.value() - value) < 1e-9,
                 qPrintable(QStringLiteral("the box reads %1, expected %2")
                                .arg(box.value(), 0, 'g', 12)
                                .arg(value, 0, 'g', 12)));
    }

    void numberBox_invalidText_isRefused_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("says");
        QTest::newRow("unknown unit") << "2 furlongs"
                                      << "furlongs";
        QTest::newRow("another quantity") << "2 s"
                                          << "mm";
        QTest::newRow("incomplete calculation") << "2*"
                                                << "“2*” is not a number";
        QTest::newRow("two meanings") << "1,234"
                                      << "1.234 or 1234";
        QTest::newRow("groups of wrong length") << "1,23.4"
                                                << "1,23.4";
        QTest::newRow("beyond the limits") << "9000"
                                           << "5000";
        QTest::newRow("far beyond the limits") << "1e308"
                                               << "range 0 to 5000";
        QTest::newRow("beyond every number") << "1e400"
                                             << "range 0 to 5000";
        QTest::newRow("beyond the limits in another unit") << "9 m"
                                                           << "5000";
        QTest::newRow("empty text") << ""
                                    << "is empty";
    }
    void numberBox_invalidText_isRefused() {
        QFETCH(QString, typed);
        QFETCH(QString, says);
        NumberBox box;
        box.setLocale(QLocale(QLocale::English));
        box.setRange(0, 5000);
        box.setSuffix(QStringLiteral(" mm"));
        box.setValue(12);
        box.setKeyboardTracking(false);
        const QSignalSpy refused(&box, &NumberBox::refused);
        box.selectAll();
        QTest::keyClick(&box, Qt::Key_Delete);
        QTest::keyClicks(&box, typed);
        QTest::keyClick(&box, Qt::Key_Return);
        QCOMPARE(refused.size(), 1);
        const QString sentence = refused[0][0].toString();
        QVERIFY2(sentence.contains(says), qPrintable(sentence));
        QCOMPARE(box.value(), 12.0);
        QCOMPARE(box.text(), QStringLiteral("12 mm")); // the box shows the value in use
        const auto colour = [](const QWidget* widget) {
            return widget->palette().color(QPalette::Text);
        };
        QTRY_COMPARE(colour(box.findChild<QLineEdit*>()), colour(&box)); // no longer red
    }

    void shownAreaAndPlace_inches_areConverted() {
        QCOMPARE(shownArea(645.16, LengthUnit::Millimetre), QStringLiteral("645 mm²"));
        QCOMPARE(shownArea(645.16, LengthUnit::Inch), QStringLiteral("1.000 in²"));
        QCOMPARE(shownPlace({25.4f, -12.7f, 0}, LengthUnit::Millimetre),
                 QStringLiteral("x 25.4; y −12.7; z 0.0 mm"));
        QCOMPARE(shownPlace({25.4f, -12.7f, 0}, LengthUnit::Inch),
                 QStringLiteral("x 1.000; y −0.500; z 0.000 in"));
    }

    void timeline_clickBesideHandle_movesHandle() {
        Timeline timeline;
        timeline.resize(600, 40);
        timeline.show();
        timeline.setFrames(100);
        auto* slider = timeline.findChild<QSlider*>();
        QTest::mouseClick(slider, Qt::LeftButton, {}, {slider->width() / 4, slider->height() / 2});
        QVERIFY2(std::abs(timeline.position() - 25) <= 4,
                 qPrintable(QStringLiteral("the handle is at frame %1, expected 25 ± 4")
                                .arg(timeline.position())));
    }

    void timeline_marks_standAtHandlePositions() {
        Timeline timeline;
        timeline.resize(600, 40);
        timeline.show();
        timeline.setFrames(100);
        timeline.setPosition(0);
        auto* slider = timeline.findChild<QSlider*>();
        const QImage before = slider->grab().toImage();
        const QColor colour(200, 30, 160);
        timeline.setMarks({{40, colour, QStringLiteral("Film tears")}});
        const QImage after = slider->grab().toImage();
        int found = 0;
        for (int x = 0; x < after.width(); ++x) {
            found += after.pixelColor(x, after.height() - 2) == colour ? x : 0;
        }
        QVERIFY2(found > 0, "no mark is drawn"); // it is three pixels wide
        QTest::mouseClick(slider, Qt::LeftButton, {}, {found / 3, slider->height() / 2});
        QVERIFY2(std::abs(timeline.position() - 40) <= 1,
                 qPrintable(QStringLiteral("the handle is at frame %1, expected 40 ± 1")
                                .arg(timeline.position())));
        QCOMPARE(slider->accessibleDescription(), QStringLiteral("Film tears"));
        const PlainTexts plainTexts(*qApp); // as in the program
        const QPoint mark(found / 3, slider->height() / 2);
        QHelpEvent help(QEvent::ToolTip, mark, slider->mapToGlobal(mark));
        QCoreApplication::sendEvent(slider, &help);
        QCOMPARE(QToolTip::text(), QStringLiteral("Film tears"));
        timeline.setFrames(100);
        timeline.setPosition(0);
        QCOMPARE(slider->grab().toImage(), before);
    }

    // A tool button does not take the focus. Until a number is read, the button may be disabled.
    void numberBox_typedText_isReadBeforeAnyAction() {
        QWidget window;
        NumberBox number(&window);
        number.setKeyboardTracking(false);
        QToolButton button(&window);
        button.setFocusPolicy(Qt::NoFocus);
        button.move(0, 60);
        QAction save;
        save.setShortcut(Qt::CTRL | Qt::Key_S);
        window.addAction(&save);
        save.setEnabled(false);
        button.setEnabled(false);
        connect(&number, &NumberBox::valueChanged, &window, [&] {
            save.setEnabled(true);
            button.setEnabled(true);
        });
        std::vector<double> saved;
        const auto keep = [&] { saved.push_back(number.value()); };
        connect(&save, &QAction::triggered, &window, keep);
        connect(&button, &QToolButton::clicked, &window, keep);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        number.setFocus();
        const auto type = [&](const QString& text) {
            number.selectAll();
            QTest::keyClicks(&number, text);
        };
        type(QStringLiteral("12"));
        QTest::keyClick(&number, Qt::Key_A, Qt::ControlModifier); // edits the text
        QCOMPARE(number.value(), 0.0);
        type(QStringLiteral("21"));
        QTest::keyClick(&number, Qt::Key_S, Qt::ControlModifier);
        type(QStringLiteral("32"));
        QTest::mouseClick(&button, Qt::LeftButton);
        type(QStringLiteral("43"));
        window.close();
        keep();
        QCOMPARE(saved, (std::vector<double>{21, 32, 43}));
    }

    // The wheel scrolls the panel and does not change a field under the pointer.
    void wheel_fieldWithoutFocus_keepsItsValue() {
        const WheelGuard guard(*qApp); // as in the program
        QWidget window;
        QComboBox list(&window);
        NumberBox number(&window);
        QLineEdit line(&window);
        list.addItems({QStringLiteral("one"), QStringLiteral("two")});
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        line.setFocus();
        const QPointF at(5, 5);
        const auto turn = [&](QWidget& field) {
            QWheelEvent wheel(at, field.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {},
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&field, &wheel);
        };
        number.setValue(5);
        turn(list);
        turn(number);
        QCOMPARE(list.currentIndex(), 0);
        QCOMPARE(number.value(), 5.0);
        for (const QWidget* field :
             {static_cast<QWidget*>(&list), static_cast<QWidget*>(&number)}) {
            QVERIFY((field->focusPolicy() & Qt::WheelFocus) != Qt::WheelFocus);
        }
        list.setFocus();
        turn(list);
        QCOMPARE(list.currentIndex(), 1);
        number.setFocus();
        turn(number);
        QCOMPARE(number.value(), 4.0);
    }

    void propertyField_ctrlZ_isTakenOnlyWhileTyping() {
        const std::unique_ptr<PropertyField> field(
            PropertyField::make(allSpecs().front(), {.kind = FieldKind::Number, .maximum = 100},
                                LengthUnit::Millimetre, nullptr));
        auto* box = field->findChild<QDoubleSpinBox*>();
        QVERIFY(box);
        const auto takesUndo = [box] {
            QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
            undo.ignore();
            QApplication::sendEvent(box, &undo);
            return undo.isAccepted();
        };
        QVERIFY(!takesUndo());
        QTest::keyClicks(box, QStringLiteral("4"));
        QVERIFY(takesUndo());
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(!takesUndo());
    }

    void propertyPanel_everyPage_showsEveryField_data() {
        QTest::addColumn<QString>("language");
        for (const Language& language : languages()) {
            QTest::newRow(qPrintable(language.code)) << language.code;
        }
    }
    // At the least width, no field may be cut off or laid out without height.
    void propertyPanel_everyPage_showsEveryField() {
        QFETCH(QString, language);
        const LanguageInUse inUse(language);
        const SolverRegistry registry;
        PropertyPanel panel(registry);
        QSignalSpy narrowing(&panel, &PropertyPanel::leastWidthChanging);
        Document document(boxProject());
        panel.setDocument(&document);
        panel.show();
        for (const ProjectPart part :
             {ProjectPart::Tolerance, ProjectPart::Model, ProjectPart::Project, ProjectPart::Film,
              ProjectPart::Process, ProjectPart::Immersion, ProjectPart::Share, ProjectPart::Ink,
              ProjectPart::Sheet}) {
            panel.showNode({part, 0});
            panel.resize(narrowing.last()[0].toInt(), 4000);
            QCoreApplication::processEvents();
            QVERIFY2(panel.width() <= 400, qPrintable(QString::number(panel.width())));
            for (const PropertyField* field : panel.findChildren<PropertyField*>()) {
                QVERIFY2(!field->isVisible() ||
                             field->height() >= field->minimumSizeHint().height(),
                         qPrintable(field->spec().path));
            }
        }
    }

    void propertyPanel_twoEnteredNumbers_areTwoUndoSteps() {
        const SolverRegistry registry;
        PropertyPanel panel(registry);
        Document document(boxProject());
        panel.showNode({ProjectPart::Film});
        panel.setDocument(&document);
        auto* box = panel.findChild<QDoubleSpinBox*>(QStringLiteral("film.size_mm"));
        QVERIFY(box);
        for (const char* typed : {"250", "260"}) {
            box->selectAll();
            QTest::keyClicks(box, QLatin1String(typed));
            QTest::keyClick(box, Qt::Key_Return);
        }
        QCOMPARE(document.project().film.width.value(), 260.0);
        QCOMPARE(document.undoStack().count(), 2);
        document.undoStack().undo();
        QCOMPARE(document.project().film.width.value(), 250.0);
        // The arrow keys change a value by many small steps, which are one undo step.
        for (int step = 0; step < 3; ++step) {
            QTest::keyClick(box, Qt::Key_Up);
        }
        QCOMPARE(document.undoStack().count(), 2);
        panel.setDocument(nullptr);
    }

    void propertyField_everyField_hasAccessibleName() {
        for (const PropertySpec& spec : allSpecs()) {
            const std::unique_ptr<PropertyField> field(
                PropertyField::make(spec, valueRule(spec.path), LengthUnit::Millimetre, nullptr));
            for (const QWidget* editor : field->findChildren<QWidget*>(spec.path)) {
                QVERIFY2(!editor->accessibleName().isEmpty(), qPrintable(spec.path));
                QVERIFY2(!editor->whatsThis().isEmpty(), qPrintable(spec.path));
            }
        }
    }

    void zoneFields_tabKey_followsTheLayout() {
        ZoneFields fields(LengthUnit::Millimetre);
        fields.show();
        auto* first = fields.findChild<QWidget*>(QStringLiteral("zoneBrush"));
        int y = first->y();
        for (QWidget* field = first->nextInFocusChain(); field != first;
             field = field->nextInFocusChain()) {
            if (field->parent() == &fields && field->focusPolicy() & Qt::TabFocus) {
                QVERIFY2(field->geometry().bottom() >= y, qPrintable(field->objectName()));
                y = field->y();
            }
        }
    }

    void zoneFields_marksNothing_allOthersAreDisabled() {
        ZoneFields fields(LengthUnit::Millimetre);
        auto* zone = fields.findChild<QComboBox*>(QStringLiteral("zoneBrush"));
        auto* extent = fields.findChild<QComboBox*>(QStringLiteral("zoneBrushExtent"));
        auto* radius = fields.findChild<QDoubleSpinBox*>(QStringLiteral("zoneBrushRadius"));
        QVERIFY(!extent->isEnabled() && !radius->isEnabled());
        zone->setCurrentIndex(1);
        QVERIFY(extent->isEnabled() && radius->isEnabled());
        extent->setCurrentIndex(1); // the whole face
        QVERIFY(extent->isEnabled() && !radius->isEnabled());
        zone->setCurrentIndex(0);
        QVERIFY(!extent->isEnabled() && !radius->isEnabled());
    }

    void themePalette_bothThemes_haveContrast() {
        for (const bool dark : {false, true}) {
            const QPalette palette = themePalette(dark);
            const std::vector<std::pair<QPalette::ColorRole, QPalette::ColorRole>> pairs{
                {QPalette::WindowText, QPalette::Window},
                {QPalette::Text, QPalette::Base},
                {QPalette::Text, QPalette::AlternateBase},
                {QPalette::ButtonText, QPalette::Button},
                {QPalette::HighlightedText, QPalette::Highlight},
                {QPalette::PlaceholderText, QPalette::Base},
                {QPalette::PlaceholderText, QPalette::Window},
                {QPalette::WindowText, QPalette::Light}, // pages of tabs
                {QPalette::PlaceholderText, QPalette::Light},
                {QPalette::Link, QPalette::Base},
                {QPalette::ToolTipText, QPalette::ToolTipBase}};
            for (const auto& [text, ground] : pairs) {
                const double ratio = contrast(palette.color(text), palette.color(ground));
                QVERIFY2(
                    ratio >= 4.5,
                    qPrintable(QStringLiteral("role %1 on role %2, dark %3: the contrast is %4, "
                                              "expected at least 4.5")
                                   .arg(text)
                                   .arg(ground)
                                   .arg(dark)
                                   .arg(ratio)));
            }
        }
    }

    void heatScale_valueOverLimit_isMarked() {
        HeatScale scale{.map = QStringLiteral("lagoon"), .low = 1, .high = 2, .limit = 1.3};
        const QRgb marked = scale.colour(1.31);
        QVERIFY(marked != scale.colour(1.29));
        QCOMPARE(marked, scale.colour(1.9));
        scale.limit.reset();
        QVERIFY(scale.colour(1.31) != marked);
    }

    void heatPicture_grid_columnsAcrossRowsDown() {
        const HeatScale scale{.map = QStringLiteral("grey"), .low = 0, .high = 3};
        // Two columns, two rows: 0 1 / 2 3.
        const QImage picture = heatPicture({0, 1, 2, 3}, {2, 2, 40, 60}, {40, 60}, scale);
        QCOMPARE(picture.size(), QSize(40, 60));
        QVERIFY(qGray(picture.pixel(39, 0)) > qGray(picture.pixel(0, 0)));
        QVERIFY(qGray(picture.pixel(0, 59)) > qGray(picture.pixel(39, 0)));
    }

    void isolines_slope_areStraight() {
        std::vector<float> values;
        for (int row = 0; row < 11; ++row) {
            for (int column = 0; column < 11; ++column) {
                values.push_back(float(column));
            }
        }
        const QList<QLineF> lines = isolines(values, {11, 11, 100, 200}, 2.5);
        QVERIFY(!lines.isEmpty());
        for (const QLineF& line : lines) {
            QVERIFY(std::abs(line.x1() - line.x2()) < 1e-9);
            QVERIFY(std::abs(std::remainder(line.x1(), 25)) < 1e-9); // the value 2.5 is at 25 mm
        }
    }

    void isolines_gradedFilm_followUnevenCells() {
        const solver::FilmGrid film{4, 2, 100, 50, {-50, -40, 10, 50}, {-25, 25}};
        std::vector<float> values;
        for (int row = 0; row < film.rows; ++row) {
            for (int column = 0; column < film.columns; ++column) {
                values.push_back(float(film.restX(column) + 50));
            }
        }
        const QList<QLineF> lines = isolines(values, film, 30);
        QVERIFY(!lines.isEmpty());
        for (const QLineF& line : lines) {
            QVERIFY(std::abs(std::remainder(line.x1(), 30)) < 1e-4);
        }
        const HeatScale scale{.map = QStringLiteral("grey"), .low = 0, .high = 100};
        const QImage picture = heatPicture(values, film, {100, 50}, scale);
        for (int x = 0; x < 100; ++x) {
            QVERIFY(std::abs(qGray(picture.pixel(x, 20)) - qGray(scale.colour(x + 0.5))) <= 1);
        }
    }

    void filmFacts_eachResolution_showsPointsOrCells() {
        Project project;
        auto model = std::make_shared<TexturedMesh>();
        model->mesh = boxMesh({60, 40, 60});
        project.model = model;
        FilmFacts facts;
        QVERIFY(facts.text(project, nullptr, LengthUnit::Millimetre).contains("120 × 170 points"));
        project.film.resolution = FilmResolution::Cell;
        project.film.cell = Millimetres(1.5);
        const QString graded = facts.text(project, nullptr, LengthUnit::Millimetre);
        QVERIFY2(graded.startsWith("Immersion: cells of 1.4"), qPrintable(graded));
        project.film.cell = Millimetres(0.02); // more points than a film may have
        QVERIFY2(facts.text(project, nullptr, LengthUnit::Millimetre).contains("larger cells"),
                 qPrintable(facts.text(project, nullptr, LengthUnit::Millimetre)));
    }

    void automaticScale_outlier_isOutsideRange() {
        std::vector<float> values(1000, 1.0f);
        values[0] = 50; // a torn point
        for (std::size_t entry = 1; entry < 500; ++entry) {
            values[entry] = 1.0f + float(entry) / 1000;
        }
        const HeatScale scale = automaticScale({}, values);
        QCOMPARE(scale.low, 1.0);
        QVERIFY(scale.high > 1.45 && scale.high < 1.6);
    }

    void verdictPanel_tornFilm_showsPaintedArea() {
        auto coverage = std::make_shared<Coverage>();
        coverage->paintedArea = 1000;
        auto result = std::make_shared<JobResult>();
        result->immersions.resize(1);
        VerdictPanel panel;
        const auto text = [&](const MarkedArea& marked) {
            coverage->marked = marked;
            result->immersions[0].coverage = std::make_shared<const Coverage>(*coverage);
            panel.setOutcome({std::make_shared<const JobResult>(*result), {}, {}}, 0,
                             LengthUnit::Millimetre);
            return panel.findChild<QTextBrowser*>(QStringLiteral("verdict"))->toPlainText();
        };
        MarkedArea marked;
        marked.add(std::uint8_t(solver::PointMark::Torn), 25);
        const QString shown = text(marked);
        QVERIFY2(shown.contains(QStringLiteral("25 mm²")), qPrintable(shown));
        QVERIFY2(shown.contains(QStringLiteral("2.5 %")), qPrintable(shown));
        QVERIFY(!text({}).contains(QStringLiteral("mm²")));
    }

    void verdictPanel_projectChanged_isGreyAndSaysSo() {
        auto result = std::make_shared<JobResult>();
        result->immersions.resize(1);
        result->immersions[0].coverage = std::make_shared<const Coverage>();
        result->verdict.advice = result->immersions[0].verdict.advice = Advice::Print;
        VerdictPanel panel;
        panel.setOutcome({result, {}, {}}, 0, LengthUnit::Millimetre);
        const auto* text = panel.findChild<QTextBrowser*>(QStringLiteral("verdict"));
        const QString heading = QStringLiteral("Before the last changes");
        const QString fresh = text->toHtml();
        QVERIFY(!text->toPlainText().contains(heading));
        QVERIFY(fresh.contains(QStringLiteral("#008a9a")));
        panel.setFresh(false);
        QVERIFY(text->toPlainText().startsWith(heading));
        QVERIFY(!text->toHtml().contains(QStringLiteral("#008a9a")));
        panel.setFresh(true);
        QCOMPARE(text->toHtml(), fresh);
    }

    void verdictPanel_draftWithoutResult_saysWhyAndWhatToDo() {
        auto result = std::make_shared<JobResult>();
        result->immersions.resize(1);
        DipOutcome draft{result, {}, {}};
        draft.fineness.level = 1;
        VerdictPanel panel;
        panel.setOutcome(draft, 0, LengthUnit::Millimetre);
        const auto text = [&panel](DraftEnd end) {
            panel.setDraftEnd(end);
            return panel.findChild<QTextBrowser*>(QStringLiteral("verdict"))->toPlainText();
        };
        QVERIFY(text(DraftEnd::Cancelled).contains(QStringLiteral("was cancelled. Run the dip")));
        QVERIFY(text(DraftEnd::Failed).contains(QStringLiteral("failed. See the log")));
        QVERIFY(text(DraftEnd::ResultFollows).contains(QStringLiteral("follows")));
    }

    void resultsPanel_jobOutdated_marksVerdictAndReport() {
        ResultsPanel panel;
        const QTabBar& bar = *panel.tabBar();
        const QString help = bar.tabToolTip(0);
        const auto marked = [&] {
            QStringList tabs;
            for (int tab = 0; tab < panel.count(); ++tab) {
                if (bar.accessibleTabName(tab).contains(QStringLiteral("out of date"))) {
                    tabs << panel.tabText(tab);
                }
            }
            return tabs;
        };
        panel.setFreshness({false, false, false}, false);
        QCOMPARE(marked().size(), panel.count());
        QVERIFY(bar.tabToolTip(0) != help);
        panel.setFreshness({}, false); // another dip is outdated
        QCOMPARE(marked(), QStringList({QStringLiteral("Verdict"), QStringLiteral("Report")}));
        panel.setFreshness({}, true);
        QVERIFY(marked().isEmpty());
        QCOMPARE(bar.tabToolTip(0), help);
    }

    void verdictPanel_narrow_scrollsOnlyVertically() {
        auto coverage = std::make_shared<Coverage>();
        coverage->paintedArea = 1000;
        coverage->marked.add(std::uint8_t(solver::PointMark::Torn), 25);
        auto result = std::make_shared<JobResult>();
        result->immersions.resize(1);
        result->immersions[0].coverage = coverage;
        result->immersions[0].verdict.advice = Advice::CheckFirst;
        result->immersions[0].verdict.reasons.resize(12);
        result->immersions[0].verdict.places.resize(5);
        VerdictPanel panel;
        panel.resize(320, 1400);
        panel.show();
        panel.setOutcome({result, {}, {}}, 0, LengthUnit::Millimetre);
        const auto* text = panel.findChild<QTextBrowser*>(QStringLiteral("verdict"));
        QTRY_COMPARE(text->verticalScrollBar()->maximum(), 0); // all words fit
        QCOMPARE(text->horizontalScrollBar()->maximum(), 0);
        panel.resize(320, 240);
        QTRY_VERIFY(text->verticalScrollBar()->maximum() > 0);
        QCOMPARE(text->horizontalScrollBar()->maximum(), 0);
    }

    void picturePanel_buttonOfTheWindow_isNotEnabledByPicture() {
        PicturePanel panel(QStringLiteral("Sheet"), {});
        QAction exportSheet(QStringLiteral("Export"));
        exportSheet.setEnabled(false);
        panel.addButton(&exportSheet);
        QImage picture(4, 4, QImage::Format_RGB32);
        picture.fill(Qt::white);
        panel.setPicture(picture, {4, 4});
        QVERIFY(!exportSheet.isEnabled());
    }

    void pictureView_hover_reportsMillimetres() {
        PictureView view;
        view.resize(400, 400);
        QImage picture(200, 100, QImage::Format_RGB32);
        view.setPicture(picture, {100, 50});
        view.show();
        QSignalSpy hovered(&view, &PictureView::hovered);
        QTest::mouseMove(&view, QPoint(200, 200));
        QTRY_VERIFY(!hovered.isEmpty());
        const QPointF place = hovered.last()[0].toPointF();
        QVERIFY(std::abs(place.x() - 50) < 0.5);
        QVERIFY(std::abs(place.y() - 25) < 0.5);
    }

    void pictureView_trueSize_matchesScreen() {
        PictureView view;
        view.resize(400, 400);
        view.setPicture(QImage(100, 100, QImage::Format_RGB32), {100, 100});
        view.zoomToTrueSize();
        QCOMPARE(view.zoom(), view.screen()->physicalDotsPerInch() / 25.4);
    }
};

QTEST_MAIN(PanelTest)
#include "PanelTest.moc"
