// The page that fills the middle of the console.
import { Store } from './store';

export const pages = ['live', 'regions', 'plan', 'review', 'space'] as const;
export type Page = (typeof pages)[number];

export const page = new Store<Page>('live');
