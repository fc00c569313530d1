// SPDX-License-Identifier: GPL-3.0-or-later
declare module '*.glsl' {
    const text: string;
    export default text;
}
declare module '*.svg' {
    const text: string;
    export default text;
}
