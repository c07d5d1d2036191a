// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QImage>

#include "core/imaging/Bitewing.h"
#include "ui/kit/Page.h"

class QHBoxLayout;
class QPushButton;
class QSlider;

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::inside {

class FilmView;

/// Shows radiographs of the tooth side by side: before cutting and now. The user can change the beam and the exposure.
/// Films are developed in a pool thread. Only the newest request is answered.
class XrayPage : public kit::Page
{
    Q_OBJECT
public:
    XrayPage(const kit::Actions& actions, QWidget* parent);

    /// Sets the tooth. The beam settings do not change.
    void setTooth(const core::terrain::Tooth& tooth);
    /// Returns both films side by side with their captions; null until they are developed.
    [[nodiscard]] QImage bothFilms() const;
    /// Returns false while a film is being developed.
    [[nodiscard]] bool isReady() const { return !m_working; }

signals:
    /// Emitted when the user requests to save both films.
    void saveRequested();

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Wish
    {
        core::imaging::Beam beam;
        double exposure = 1.0;
        bool bitewing = false;
        double widthToHeight = 1.0;  ///< aspect ratio of the space for a film
    };
    struct Films
    {
        QImage before;
        QImage now;
        std::shared_ptr<const std::vector<core::imaging::Neighbour>> neighbours;
    };

    QWidget* makeControls(const kit::Actions& actions);
    void addScenes(QHBoxLayout* row, QWidget* card);
    void addSliders(QHBoxLayout* row, QWidget* card);
    [[nodiscard]] core::imaging::Beam ownBeam() const;
    [[nodiscard]] Wish wish() const;
    void retranslateUi();
    void nameSides();
    void develop();
    void take(const Films& films, const core::terrain::ToothAnatomy* of);
    void updateValues();
    static Films filmsOf(const core::terrain::Tooth& tooth, const Wish& wish,
                         std::shared_ptr<const std::vector<core::imaging::Neighbour>> neighbours);

    std::optional<core::terrain::Tooth> m_tooth;
    std::shared_ptr<const std::vector<core::imaging::Neighbour>> m_neighbours;  ///< of m_tooth; null until needed
    FilmView* m_before;
    FilmView* m_now;
    QPushButton* m_oneTooth = nullptr;
    QPushButton* m_bitewing = nullptr;
    QSlider* m_angle = nullptr;
    QSlider* m_tilt = nullptr;
    QSlider* m_exposure = nullptr;
    kit::TabularDigitsLabel* m_angleText = nullptr;
    kit::TabularDigitsLabel* m_tiltText = nullptr;
    kit::TabularDigitsLabel* m_exposureText = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_back = nullptr;
    bool m_working = false;
    bool m_again = false;  ///< the settings changed while a film was being developed
};

}  // namespace ui::inside
