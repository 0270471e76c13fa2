// The options of `el` in ui/dom.js.

interface Attributes {
  hidden?: boolean;
  href?: string;
  max?: string;
  min?: string;
  open?: boolean;
  placeholder?: string;
  role?: string;
  scope?: 'row' | 'col';
  selected?: boolean;
  step?: string;
  tabindex?: number;
  title?: string;
  type?: string;
  value?: string | number;
  'aria-expanded'?: 'true' | 'false';
  'aria-label'?: string;
  'aria-live'?: 'off' | 'polite';
}

export interface ElementOptions extends Attributes {
  class?: string;
  text?: string;
  on?: { [E in keyof HTMLElementEventMap]?: (event: HTMLElementEventMap[E]) => void };
  data?: Record<string, string | number>; // data-*
  style?: Record<string, string>; // CSS properties, including custom ones
}

export type Child = Node | string | null | undefined;
