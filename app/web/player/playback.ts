// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the player without clock or window, as model/animation/playback.h: time is handed in. Whoever shares
// playback with others sets state() and listens to `change`.

export const LeastRate = 1;
export const MostRate = 240;

export interface PlaybackState {
    isPlaying: boolean;
    rate: number;
    frame: number;
    loops: boolean;
}

export class Playback extends EventTarget {
    private frames = 1;
    private place = 0; // frame and the share of the next one that has passed
    private playing = false;
    private framesPerSecond = 25;
    private isLoop = true;

    get frameCount(): number {
        return this.frames;
    }
    get frame(): number {
        return Math.min(Math.floor(this.place), this.frames - 1);
    }
    get isPlaying(): boolean {
        return this.playing;
    }
    get rate(): number {
        return this.framesPerSecond;
    }
    get loops(): boolean {
        return this.isLoop;
    }

    /// Another animation: its first frame, and its own rate.
    reset(frameCount: number, rate: number): void {
        this.frames = Math.max(frameCount, 1);
        this.place = 0;
        this.framesPerSecond = clampRate(rate);
        this.changed();
    }

    play(): void {
        if (!this.isLoop && this.frame === this.frames - 1) this.place = 0;
        this.playing = true;
        this.changed();
    }
    pause(): void {
        this.playing = false;
        this.changed();
    }
    toggle(): void {
        if (this.playing) this.pause();
        else this.play();
    }
    seek(frame: number): void {
        if (!Number.isFinite(frame)) return;
        this.place = Math.min(Math.max(Math.round(frame), 0), this.frames - 1);
        this.changed();
    }
    /// Pauses, as somebody who steps wants to look.
    step(frames: number): void {
        this.playing = false;
        this.seek(this.frame + frames);
    }
    setRate(rate: number): void {
        if (!Number.isFinite(rate)) return;
        this.framesPerSecond = clampRate(rate);
        this.changed();
    }
    setLoops(loops: boolean): void {
        this.isLoop = loops;
        this.changed();
    }

    state(): PlaybackState {
        return { isPlaying: this.playing, rate: this.framesPerSecond, frame: this.frame, loops: this.isLoop };
    }

    /// Time passes; frames are left out where drawing is slow.
    advance(seconds: number): void {
        if (!this.playing || !(seconds > 0)) return;
        const before = this.frame;
        this.place += seconds * this.framesPerSecond;
        if (this.place >= this.frames) {
            if (this.isLoop) {
                this.place %= this.frames;
            } else {
                this.place = this.frames - 1;
                this.playing = false;
            }
        }
        if (this.frame !== before || !this.playing) this.changed();
    }

    private changed(): void {
        this.dispatchEvent(new Event('change'));
    }
}

function clampRate(rate: number): number {
    return Math.min(Math.max(rate, LeastRate), MostRate);
}
