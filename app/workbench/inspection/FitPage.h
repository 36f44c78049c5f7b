// The page that fits film and dip to photos of a dipped part.
#pragma once

#include "inspection/FilmFitFiles.h"
#include "project/Project.h"

#include <QWidget>
#include <memory>

class QLabel;
class QPushButton;
class QTableWidget;

namespace dipwright {

// A fit and its inputs.
struct FittedPart {
    Project project; // before the fit
    FitPairs pairs;
    std::vector<FittedPhoto> photos;
    FilmFit fit;
};

class FitPage : public QWidget {
    Q_OBJECT

public:
    explicit FitPage(QWidget* parent = nullptr);

    // `ready`: there are corners to fit to. `hasBody`: there are pairs on the body, too.
    void setReady(bool ready, bool hasBody);
    // Shows the fit; null: none, or the inputs have changed since. `isUsed`: the project uses it.
    void setFitted(std::shared_ptr<const FittedPart> fitted, bool isUsed);
    void setRefusal(const QString& sentence); // says why the fit failed
    void setBusy(bool busy);

signals:
    void fitAsked();
    void useAsked();
    void saveAsked();
    void exportAsked();

private:
    QWidget* makeButtons();
    void showQuantities();
    void showCorrelations();
    void enable();
    void say();

    std::shared_ptr<const FittedPart> fitted_;
    QString refusal_;
    bool ready_ = false, hasBody_ = false, busy_ = false, isUsed_ = false;
    QLabel *hint_, *words_;
    QPushButton *fit_, *use_, *save_, *export_;
    QTableWidget *quantities_, *correlations_;
};

} // namespace dipwright
