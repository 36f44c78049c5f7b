// Tests the page of the pose search with made-up results.
#include "workbench/poses/MeasurePlot.h"
#include "workbench/poses/OrientationMap.h"
#include "workbench/poses/PoseTable.h"
#include "workbench/poses/SearchPage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace dipwright;

namespace {

RankedPoses poses(double objective, double coverage, double stretch, Degrees aboutX) {
    RankedPoses ranked;
    Immersion immersion;
    immersion.rotation[0] = aboutX;
    ranked.immersions = {immersion};
    ranked.objective = objective;
    ranked.measures[Measure::Coverage] = coverage;
    ranked.measures[Measure::Stretch] = stretch;
    ranked.isConfirmed = true;
    return ranked;
}

SearchResult result() {
    SearchResult found;
    found.ranking = {poses(0.8, 0.70, 1.5, Degrees(0)), poses(0.7, 0.75, 1.9, Degrees(90)),
                     poses(0.6, 0.60, 2.4, Degrees(180))};
    found.current = poses(0.5, 0.5, 2, Degrees(45));
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            found.directions.push_back(
                {sign * Eigen::Vector3d::Unit(axis), 0.5, axis == 1 && sign < 0 ? 0.8 : 0.3});
        }
    }
    found.directions.push_back({Eigen::Vector3d(1, 1, 0).normalized(), 0.1, std::nullopt});
    return found;
}

} // namespace

class PosesTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        page_ = std::make_unique<SearchPage>();
        page_->resize(400, 700);
        page_->show();
        page_->setResult(result(), {});
        table_ = page_->findChild<PoseTable*>();
    }

    void poseTable_everyRank_showsObjectiveAndReason() {
        QCOMPARE(table_->rowCount(), 3);
        const auto text = [this](int row) { return table_->item(row, 2)->text(); };
        QVERIFY2(text(0).contains(QLatin1String("Compared with your pose")), qPrintable(text(0)));
        QVERIFY2(text(1).contains(QLatin1String("coverage"), Qt::CaseInsensitive) &&
                     text(1).contains(QLatin1String("stretch"), Qt::CaseInsensitive),
                 qPrintable(text(1)));
        QVERIFY2(table_->item(0, 1)->text().startsWith(QLatin1String("80.0\n")),
                 qPrintable(table_->item(0, 1)->text()));
    }

    void poseTable_reasons_areNotCutOffAndSayBetterOrWorse() {
        QTest::qWait(20); // until the rows are laid out
        for (int row = 0; row < table_->rowCount(); ++row) {
            const QModelIndex index = table_->model()->index(row, 2);
            QStyleOptionViewItem option;
            option.font = table_->font();
            const int needed = table_->itemDelegateForColumn(2)->sizeHint(option, index).height();
            QVERIFY2(table_->rowHeight(row) >= needed,
                     qPrintable(QStringLiteral("row %1 is %2 px high, its text %3 px")
                                    .arg(row)
                                    .arg(table_->rowHeight(row))
                                    .arg(needed)));
        }
        const QString html = table_->item(1, 2)->data(Qt::UserRole).toString();
        QVERIFY2(html.contains(QStringLiteral("▼</span> Worse: ")), qPrintable(html));
    }

    void measurePlot_axes_haveValuesWithUnits() {
        const auto* field = page_->findChild<QWidget*>(QStringLiteral("measurePlot"));
        QVERIFY2(field->accessibleDescription().contains(QLatin1String("Coverage: worst")) &&
                     field->accessibleDescription().contains(QLatin1String(" %")),
                 qPrintable(field->accessibleDescription()));
    }

    void searchPage_takePose_emitsChosenPose() {
        QSignalSpy applied(page_.get(), &SearchPage::applyAsked);
        auto* take = page_->findChild<QPushButton*>(QStringLiteral("takePose"));
        QVERIFY(!take->isEnabled());
        table_->choose(1);
        take->click();
        QCOMPARE(applied.count(), 1);
        QCOMPARE(applied[0][0].value<RankedPoses>().objective, 0.7);
    }

    void setResult_rankingChanges_selectionStaysAtThePose() {
        table_->choose(1);
        SearchResult changed = result();
        changed.ranking.insert(changed.ranking.begin(), poses(0.9, 0.9, 1.2, Degrees(30)));
        page_->setResult(changed, {});
        QCOMPARE(table_->chosen(), (std::vector<std::size_t>{2}));
        QCOMPARE(table_->currentRow(), 2);
        QSignalSpy applied(page_.get(), &SearchPage::applyAsked);
        page_->findChild<QPushButton*>(QStringLiteral("takePose"))->click();
        QCOMPARE(applied[0][0].value<RankedPoses>().objective, 0.7);
    }

    void setResult_rankingChanges_theSamePosesAreCompared() {
        table_->selectRow(0);
        table_->selectionModel()->select(table_->model()->index(2, 0),
                                         QItemSelectionModel::Select | QItemSelectionModel::Rows);
        SearchResult changed = result();
        std::swap(changed.ranking[0], changed.ranking[1]);
        page_->setResult(changed, {});
        const auto* words = page_->findChild<QLabel*>(QStringLiteral("poseComparison"));
        QVERIFY2(words->text().contains(QLatin1String("Rank 2 compared with rank 3")),
                 qPrintable(words->text()));
    }

    void setResult_poseLeavesTheRanking_nothingIsSelected() {
        table_->choose(1);
        SearchResult changed = result();
        changed.ranking[1] = poses(0.7, 0.75, 1.9, Degrees(91));
        page_->setResult(changed, {});
        QVERIFY(table_->chosen().empty());
        QVERIFY(!page_->findChild<QPushButton*>(QStringLiteral("takePose"))->isEnabled());
    }

    // Row 1 holds the pose with the objective 0.7.
    void searchPage_click_asksToSeeThePose() {
        QSignalSpy looked(page_.get(), &SearchPage::lookAsked);
        const auto click = [this](int row, Qt::KeyboardModifiers modifiers) {
            QTest::mouseClick(table_->viewport(), Qt::LeftButton, modifiers,
                              table_->visualItemRect(table_->item(row, 0)).center());
        };
        click(1, Qt::NoModifier);
        QCOMPARE(looked.count(), 1);
        QCOMPARE(looked[0][0].value<RankedPoses>().objective, 0.7);
    }

    void searchPage_twoRowsSelected_comparesInWords() {
        auto* words = page_->findChild<QLabel*>(QStringLiteral("poseComparison"));
        QVERIFY2(words->text().contains(QLatin1String("Click a pose")), qPrintable(words->text()));
        table_->selectRow(0);
        table_->selectionModel()->select(table_->model()->index(2, 0),
                                         QItemSelectionModel::Select | QItemSelectionModel::Rows);
        QVERIFY(words->isVisible());
        QVERIFY2(words->text().contains(QLatin1String("Rank 1 compared with rank 3")),
                 qPrintable(words->text()));
    }

    void searchPage_sideBySide_emitsBothPoses() {
        QSignalSpy asked(page_.get(), &SearchPage::comparisonAsked);
        auto* button = page_->findChild<QPushButton*>(QStringLiteral("sideBySide"));
        QVERIFY(!button->isEnabled());
        table_->selectRow(0);
        table_->selectionModel()->select(table_->model()->index(2, 0),
                                         QItemSelectionModel::Select | QItemSelectionModel::Rows);
        button->click();
        QCOMPARE(asked.count(), 1);
        const auto states = asked[0][0].value<std::array<ComparedState, 2>>();
        QCOMPARE(states[0].title, QStringLiteral("Rank 1"));
        QCOMPARE(states[1].title, QStringLiteral("Rank 3"));
        bool saysWorse = false; // rank 3 paints less
        for (std::size_t row = 0; row < states[0].figures.size(); ++row) {
            if (states[0].figures[row].name == measureName(Measure::Coverage)) {
                saysWorse = differenceText(states[0].figures[row], states[1].figures[row])
                                .contains(QLatin1String("worse"));
            }
        }
        QVERIFY(saysWorse);
    }

    void orientationMap_click_picksDirection() {
        OrientationMap map;
        map.resize(200, 200);
        map.show();
        map.setDirections(result().directions);
        QSignalSpy picked(&map, &OrientationMap::picked);
        const auto pick = [&](QPoint place) {
            QTest::mouseClick(&map, Qt::LeftButton, {}, place);
            return picked.takeLast()[0].value<Eigen::Vector3d>();
        };
        QCOMPARE(pick({100, 100}), Eigen::Vector3d(0, -1, 0));
        QCOMPARE(pick({165, 100}), Eigen::Vector3d(1, 0, 0));
        QCOMPARE(pick({100, 165}), Eigen::Vector3d(0, 0, 1));
        QCOMPARE(pick({100, 8}), Eigen::Vector3d(0, 1, 0));
        QTest::mouseClick(&map, Qt::LeftButton, {}, {2, 2}); // off the disc
        QVERIFY(picked.isEmpty());
        const QImage picture = map.grab().toImage();
        QVERIFY(picture.pixelColor(100, 100).lightness() >
                picture.pixelColor(165, 100).lightness()); // better directions are lighter
    }

    void paretoOptimalRanks_twoMeasures_dropsWorsePose() {
        const std::vector<RankedPoses> ranking = result().ranking;
        // The third pose paints less, with more stretch, than both others.
        QCOMPARE(paretoOptimalRanks(ranking, Measure::Coverage, Measure::Stretch),
                 (std::vector<std::size_t>{0, 1}));
    }

    void searchPage_limitChecked_setsLimit() {
        QCheckBox* wanted = nullptr;
        QDoubleSpinBox* limit = nullptr;
        const QString name = QStringLiteral("Limit of ") + measureName(Measure::Coverage);
        for (auto* box : page_->findChildren<QCheckBox*>()) {
            wanted = box->accessibleName() == name ? box : wanted;
        }
        for (auto* box : page_->findChildren<QDoubleSpinBox*>()) {
            limit = box->accessibleName() == name ? box : limit;
        }
        QVERIFY(wanted && limit);
        QCOMPARE(page_->settings(), SearchSettings());
        wanted->setChecked(true);
        limit->setValue(85);
        QCOMPARE(page_->settings().aims.limits[Measure::Coverage], std::optional(0.85));
        wanted->setChecked(false);
        QCOMPARE(page_->settings(), SearchSettings());
    }

    void searchPage_searching_canBePausedAndStopped() {
        auto* pause = page_->findChild<QPushButton*>(QStringLiteral("pauseSearch"));
        auto* stop = page_->findChild<QPushButton*>(QStringLiteral("stopSearch"));
        auto* start = page_->findChild<QPushButton*>(QStringLiteral("startSearch"));
        QVERIFY(start->isEnabled() && !pause->isEnabled() && !stop->isEnabled());
        page_->setState(SearchPage::State::Searching);
        QVERIFY(!start->isEnabled() && pause->isEnabled() && stop->isEnabled());
        QSignalSpy paused(page_.get(), &SearchPage::pauseAsked);
        pause->click();
        pause->click();
        QCOMPARE(paused.count(), 2);
        QCOMPARE(paused[0][0].toBool(), true);
        QCOMPARE(paused[1][0].toBool(), false);
    }

private:
    std::unique_ptr<SearchPage> page_;
    PoseTable* table_ = nullptr;
};

QTEST_MAIN(PosesTest)
#include "PosesTest.moc"
