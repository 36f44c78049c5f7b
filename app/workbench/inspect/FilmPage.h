// The page of a film on the water: its photos with their times, and what they say.
#pragma once

#include "inspection/FilmWatch.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace dipwright {

class PicturePanel;

// A photo that is to be measured.
struct FilmPhoto {
    QString file;
    std::optional<double> seconds; // since the film was laid
};

class FilmPage : public QWidget {
    Q_OBJECT

public:
    explicit FilmPage(QWidget* parent = nullptr);

    void addPhotos(const QStringList& files);
    std::vector<FilmPhoto> photos() const;
    double begin() const; // of the dip, seconds
    void setBegin(double seconds);
    WatchNotes notes() const;
    // Null: nothing was measured.
    void setMeasured(std::shared_ptr<const FilmWatch> watch);
    std::shared_ptr<const FilmWatch> measured() const { return watch_; }
    void setBusy(bool busy);

signals:
    void measureAsked();
    void saveAsked();
    void exportAsked();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QWidget* makeButtons();
    void removeChosen();
    void enable();

    bool busy_ = false;
    std::shared_ptr<const FilmWatch> watch_;
    QTableWidget* table_;
    QDoubleSpinBox *begin_, *water_;
    QLineEdit* lot_;
    QPushButton *remove_, *measure_, *save_, *export_;
    QLabel* words_;
    PicturePanel* map_;
};

} // namespace dipwright
