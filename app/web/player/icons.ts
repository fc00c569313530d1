// SPDX-License-Identifier: GPL-3.0-or-later
// The editor's icons.
import close from '../../../resources/icons/close.svg';
import firstFrame from '../../../resources/icons/first-frame.svg';
import fit from '../../../resources/icons/fit.svg';
import fullScreen from '../../../resources/icons/full-screen.svg';
import keyboard from '../../../resources/icons/keyboard.svg';
import lastFrame from '../../../resources/icons/last-frame.svg';
import loop from '../../../resources/icons/loop.svg';
import pause from '../../../resources/icons/pause.svg';
import play from '../../../resources/icons/play.svg';
import points from '../../../resources/icons/points.svg';
import shaded from '../../../resources/icons/shaded.svg';
import stepBack from '../../../resources/icons/step-back.svg';
import stepForward from '../../../resources/icons/step-forward.svg';
import wireframe from '../../../resources/icons/wireframe.svg';

export const icons = {
    close, firstFrame, fit, fullScreen, keyboard, lastFrame, loop, pause, play, points, shaded, stepBack, stepForward, wireframe,
};

/// The markup of an icon that a screen reader passes over.
export function icon(name: keyof typeof icons): string {
    return icons[name].replace('<svg ', '<svg aria-hidden="true" focusable="false" ');
}
